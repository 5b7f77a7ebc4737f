// A square of the floor (world y = 0) around the eye.

layout(location = 0) uniform mat4 clip_from_world[2];  // of each eye
layout(location = 2) uniform vec3 eye_m[2];
layout(location = 4) uniform float reach_m;

out vec2 floor_xz;
flat out vec2 eye_xz;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  eye_xz = eye_m[this_eye()].xz;
  floor_xz = eye_xz + reach_m * corner;
  gl_Position = in_part_of_eye(clip_from_world[this_eye()] * vec4(floor_xz.x, 0.0, floor_xz.y, 1.0));
}
