// One square point per depth pixel, as large on the screen as the surface between it and its neighbours.

layout(location = 2) uniform float size_at_equal_distance_px;  // of a surface that faces its sensor

const float kMinSizePx = 1.0;
const float kMaxSizePx = 48.0;
// A surface at a slant spreads its points; past this the squares would be seen as such.
const float kMaxSpread = 2.5;
const vec2 kMaxGap = vec2(0.012, 0.022);  // to a neighbour: metres, and share of the distance

flat out vec3 tint;

// How much further than on a surface that faces the sensor the next point lies, for a neighbour `step` away.
float spread_towards(ivec2 pixel, ivec2 step, float z) {
  ivec2 last = textureSize(depth_mm, 0) - 1;
  float next = z_at(clamp(pixel + step, ivec2(0), last));
  if (next == 0.0 || abs(next - z) > kMaxGap.x + kMaxGap.y * z) return 1.0;
  vec2 across = texelFetch(rays, clamp(pixel + step, ivec2(0), last), 0).xy - texelFetch(rays, pixel, 0).xy;
  float flat_step = max(length(across) * z, 1.0e-6);
  return length(vec2(flat_step, next - z)) / flat_step;
}

void main() {
  ivec2 pixel = pixel_of(gl_VertexID);
  float z = z_at(pixel);
  tint = tint_at(pixel);
  gl_Position = kOutsideClip;
  gl_PointSize = kMinSizePx;
  if (z == 0.0) return;
  vec3 in_view = point_in_view(pixel, z);
  float spread = max(spread_towards(pixel, ivec2(1, 0), z), spread_towards(pixel, ivec2(0, 1), z));
  float size_px = size_at_equal_distance_px * z / max(-in_view.z, 1.0e-3);
  gl_Position = clip_position(pixel, in_view);
  gl_PointSize = clamp(size_px * min(spread, kMaxSpread), kMinSizePx, kMaxSizePx);
}
