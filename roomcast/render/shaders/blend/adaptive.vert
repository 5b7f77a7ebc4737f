// Vertices of a cleaned surface's adaptive mesh.

out vec3 at;  // (u, v, 1) * z, u and v from 0 to 1 in the depth grid; correct across large triangles

void main() {
  ivec2 pixel = pixel_of(gl_VertexID);
  at = vec3((vec2(pixel) + 0.5) / vec2(textureSize(depth_m, 0)), 1.0) * z_at(pixel);
  gl_Position = in_part_of_eye(clip_from(point_in_view(pixel)));
}
