// Transforms a cleaned surface to the view. Comes before vertex shaders, after eyes.glsl, surface_view.glsl and
// blend_surface.glsl.

layout(binding = 6) uniform sampler2D velocities;  // metres per second in the sensor's frame (SurfaceFlow)

layout(location = 5) uniform float setback_m;  // along the eye's ray
layout(location = 7) uniform float ahead_s;    // draws what moves where it is after this time; 0: where it was seen

vec3 point_in_view(ivec2 pixel) {
  float z = z_at(pixel);
  vec3 seen_at = vec3(texelFetch(rays, pixel, 0).xy * z, z);
  // A software driver runs both sides of a branch, but ends a loop that has no turns.
  for (int i = 0; i < (ahead_s != 0.0 ? 1 : 0); ++i) seen_at += ahead_s * texelFetch(velocities, pixel, 0).xyz;
  vec3 point = in_view(seen_at);
  return point * (1.0 + setback_m / max(-point.z, 1.0e-3));
}
