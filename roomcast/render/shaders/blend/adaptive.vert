// The few vertices of a cleaned surface.

out vec3 at;  // in the depth grid, 0..1: to be divided by its last, for large triangles

void main() {
  ivec2 pixel = pixel_of(gl_VertexID);
  at = vec3((vec2(pixel) + 0.5) / vec2(textureSize(depth_m, 0)), 1.0) * z_at(pixel);
  gl_Position = in_part_of_eye(clip_from(point_in_view(pixel)));
}
