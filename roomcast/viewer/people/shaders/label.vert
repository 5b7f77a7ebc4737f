// A rectangle of a label: a letter, or the plate behind the letters.

layout(location = 0) uniform mat4 clip_from_label[2];  // of each eye

layout(location = 0) in vec2 place;     // on the label, metres
layout(location = 1) in vec2 in_atlas;  // of a letter; for the plate -1 to 1

out vec2 uv;

void main() {
  uv = in_atlas;
  gl_Position = in_part_of_eye(clip_from_label[this_eye()] * vec4(place, 0.0, 1.0));
}
