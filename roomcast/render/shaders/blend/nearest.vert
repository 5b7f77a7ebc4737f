void main() { gl_Position = in_part_of_eye(clip_from(point_in_view(pixel_of(gl_VertexID)))); }
