// Comes after a line that defines kTwoEyes.

layout(location = 4) uniform int sensor;
layout(location = 7) uniform float eye_width_px;

flat in vec3 tint;
flat in int drawn_for;
layout(location = 0) out vec4 picture;
layout(location = 1) out int drawn_by;

void main() {
  // A square can reach over the border of its eye's part, because clipping tests only the square's centre. The one-eye
  // shader has no discard: a shader with one is a tenth slower.
  if (kTwoEyes && int(gl_FragCoord.x / eye_width_px) != drawn_for) discard;
  picture = vec4(tint, 1.0);
  drawn_by = sensor;
}
