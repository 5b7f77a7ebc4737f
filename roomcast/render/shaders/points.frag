// Put behind a line that says whether kTwoEyes.

layout(location = 4) uniform int sensor;
layout(location = 7) uniform float eye_width_px;

flat in vec3 tint;
flat in int drawn_for;
layout(location = 0) out vec4 picture;
layout(location = 1) out int drawn_by;

void main() {
  // A square reaches over the border of the eye's part although its middle, which is what clipping asks for, does not.
  // A shader that may discard is a tenth slower, so that of one eye does not.
  if (kTwoEyes && int(gl_FragCoord.x / eye_width_px) != drawn_for) discard;
  picture = vec4(tint, 1.0);
  drawn_by = sensor;
}
