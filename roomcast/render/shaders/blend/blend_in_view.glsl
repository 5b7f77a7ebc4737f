// Transforms a cleaned surface to the view. Comes before vertex shaders, after eyes.glsl, surface_view.glsl,
// blend_surface.glsl and scene_flow.glsl.

layout(location = 5) uniform float setback_m;  // along the eye's ray
layout(location = 7) uniform float ahead_s;    // draws what moves where it is after this time; 0: where it was seen

// Between the four cells around the pixel, of those whose surface this is. Most surfaces stand still: a software driver
// runs both sides of a branch, but ends a loop that has no turns.
vec3 velocity_at(ivec2 pixel, float z) {
  bool may_move = ahead_s != 0.0 && texelFetch(flow, pixel / kCellPixels, 0).w != 0.0;
  vec2 at = (vec2(pixel) + 0.5) / float(kCellPixels) - 0.5;
  ivec2 first = ivec2(floor(at)), last = textureSize(flow, 0) - 1;
  vec2 part = at - vec2(first);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < (may_move ? 4 : 0); ++i) {
    ivec2 beside = ivec2(i & 1, i >> 1);
    vec4 cell = texelFetch(flow, clamp(first + beside, ivec2(0), last), 0);
    vec2 share = mix(1.0 - part, part, vec2(beside));
    if (z < cell.w) sum += vec4(cell.xyz, 1.0) * share.x * share.y;
  }
  return sum.a > 0.0 ? sum.xyz / sum.a : vec3(0.0);
}

vec3 point_in_view(ivec2 pixel) {
  float z = z_at(pixel);
  vec3 seen_at = vec3(texelFetch(rays, pixel, 0).xy * z, z);
  seen_at += ahead_s * velocity_at(pixel, z);
  vec3 point = in_view(seen_at);
  return point * (1.0 + setback_m / max(-point.z, 1.0e-3));
}
