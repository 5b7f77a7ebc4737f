// A square of the floor (world y = 0) around the eye.

layout(location = 0) uniform mat4 clip_from_world;
layout(location = 1) uniform vec3 eye;
layout(location = 2) uniform float reach_m;

out vec2 floor_xz;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  floor_xz = eye.xz + reach_m * corner;
  gl_Position = clip_from_world * vec4(floor_xz.x, 0.0, floor_xz.y, 1.0);
}
