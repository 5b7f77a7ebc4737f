// The room's model: what stands still, in world coordinates, with colours.

layout(location = 0) uniform mat4 clip_from_world[2];  // of each eye

layout(location = 0) in vec3 at_m;
layout(location = 1) in vec4 level;

out vec3 color;

void main() {
  color = level.rgb;
  gl_Position = in_part_of_eye(clip_from_world[this_eye()] * vec4(at_m, 1.0));
}
