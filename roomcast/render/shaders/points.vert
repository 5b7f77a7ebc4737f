// One square point per depth pixel, as large as the screen distance to its neighbours on the surface, or one pixel.

layout(location = 5) uniform float size_at_equal_distance_px[2];  // per eye, for a surface that faces its sensor;
                                                                // 0: always one pixel

const float kMinSizePx = 1.0;
const float kMaxSizePx = 48.0;
// Points are farther apart on a slanted surface; beyond this factor single squares would become visible.
const float kMaxSpread = 2.0;
const vec2 kMaxGap = vec2(0.012, 0.022);  // to a neighbour: metres, and share of the distance
const vec4 kOutsideClip = vec4(2.0, 2.0, 2.0, 1.0);

flat out vec3 tint;
flat out int drawn_for;  // eye number

// Distance to the neighbour at `step`, relative to that on a surface facing the sensor; 0 across a break.
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
  // A reading confirmed neither by a neighbour nor by the colour camera is noise: a grey speck in the air.
  if (spread == 0.0 && !color_is_seen(pixel)) return;
  vec3 point = point_in_view(pixel, z);
  float size_px = size_at_equal_distance_px[this_eye()] * z / max(-point.z, 1.0e-3);
  gl_Position = clip_position(pixel, point);
  gl_PointSize = clamp(size_px * clamp(spread, 1.0, kMaxSpread), kMinSizePx, kMaxSizePx);
}
