void main() { gl_Position = clip_from_view * vec4(point_in_view(pixel_of(gl_VertexID)), 1.0); }
