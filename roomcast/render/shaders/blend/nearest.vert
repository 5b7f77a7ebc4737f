// The nearest surface, set back by as much as others may lie behind it and still be mixed with it.

void main() {
  vec3 point = point_in_view(pixel_of(gl_VertexID));
  float away = max(-point.z, 1.0e-3);
  gl_Position = clip_from_view * vec4(point * (1.0 + (kMix_m + kMixPer_m * away) / away), 1.0);
}
