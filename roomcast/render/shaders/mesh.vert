// Vertices of the depth grid, fetched from the pictures; surface_mesh.comp decides which of them form triangles.

out vec3 tint;

void main() {
  ivec2 pixel = pixel_of(gl_VertexID);
  tint = tint_at(pixel);
  gl_Position = clip_position(pixel, point_in_view(pixel, z_at(pixel)));
}
