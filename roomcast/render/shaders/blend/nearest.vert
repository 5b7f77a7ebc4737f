void main() {
  vec3 point = point_in_view(pixel_of(gl_VertexID));
  float away = max(-point.z, 1.0e-3);
  gl_Position = clip_from_view * vec4(point * (set_back(away) / away), 1.0);
}
