// One square point per depth pixel: as large on the screen as the surface between it and its neighbours, or one pixel.

layout(location = 5) uniform float size_at_equal_distance_px[2];  // for each eye, of a surface that faces its sensor;
                                                                // 0: one pixel, always

const float kMinSizePx = 1.0;
const float kMaxSizePx = 48.0;
// A surface at a slant spreads its points; past this the squares would be seen as such.
const float kMaxSpread = 2.0;
const vec2 kMaxGap = vec2(0.012, 0.022);  // to a neighbour: metres, and share of the distance
const vec4 kOutsideClip = vec4(2.0, 2.0, 2.0, 1.0);

flat out vec3 tint;
flat out int drawn_for;  // which eye

// How much further than on a surface that faces the sensor the neighbour `step` away lies; 0 when none is near.
float spread_towards(ivec2 pixel, ivec2 step, float z) {
  ivec2 neighbour = min(pixel + step, textureSize(depth_mm, 0) - 1);
  float apart = z_at(neighbour) - z;
  if (abs(apart) > kMaxGap.x + kMaxGap.y * z) return 0.0;
  float across = z * distance(texelFetch(rays, neighbour, 0).xy, texelFetch(rays, pixel, 0).xy);
  return length(vec2(across, apart)) / max(across, 1.0e-6);
}

void main() {
  ivec2 pixel = pixel_of(gl_VertexID);
  float z = z_at(pixel);
  tint = tint_at(pixel);
  drawn_for = this_eye();
  gl_Position = kOutsideClip;
  gl_PointSize = kMinSizePx;
  if (z == 0.0) return;
  float spread = max(spread_towards(pixel, ivec2(1, 0), z), spread_towards(pixel, ivec2(0, 1), z));
  // A reading that neither a neighbour nor the colour camera confirms hangs in the air as a grey speck: noise.
  if (spread == 0.0 && !color_is_seen(pixel)) return;
  vec3 point = point_in_view(pixel, z);
  float size_px = size_at_equal_distance_px[this_eye()] * z / max(-point.z, 1.0e-3);
  gl_Position = clip_position(pixel, point);
  gl_PointSize = clamp(size_px * clamp(spread, 1.0, kMaxSpread), kMinSizePx, kMaxSizePx);
}
