// Transforms a cleaned surface to the view. Comes before vertex shaders, after eyes.glsl, surface_view.glsl and
// blend_surface.glsl.

layout(location = 5) uniform float setback_m;  // along the eye's ray

vec3 point_in_view(ivec2 pixel) {
  float z = z_at(pixel);
  vec3 point = in_view(vec3(texelFetch(rays, pixel, 0).xy * z, z));
  return point * (1.0 + setback_m / max(-point.z, 1.0e-3));
}
