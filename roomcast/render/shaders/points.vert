// One point per depth pixel, as large on the screen as that pixel is on the surface.

layout(location = 2) uniform float size_at_equal_distance_px;

const float kMinSizePx = 1.0;
const float kMaxSizePx = 48.0;

flat out vec3 tint;

void main() {
  ivec2 pixel = pixel_of(gl_VertexID);
  float z = z_at(pixel);
  tint = tint_at(pixel);
  gl_Position = kOutsideClip;
  gl_PointSize = kMinSizePx;
  if (z == 0.0) return;
  vec3 in_view = point_in_view(pixel, z);
  gl_Position = clip_position(pixel, in_view);
  gl_PointSize = clamp(size_at_equal_distance_px * z / max(-in_view.z, 1.0e-3), kMinSizePx, kMaxSizePx);
}
