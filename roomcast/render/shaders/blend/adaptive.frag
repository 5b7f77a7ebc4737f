// Draws a cleaned surface. A surface without a colour is grey and is moved back by a share of its distance, so that
// another sensor that saw the colour of the same surface wins although its depth is as noisy.

layout(location = 0) uniform mat4 clip_from_view[2];  // near and far are the same for all eyes
layout(location = 4) uniform int sensor;

in vec3 at;
layout(location = 0) out vec4 picture;
layout(location = 1) out int drawn_by;
layout(depth_greater) out float gl_FragDepth;

const vec3 kUnseenGrey = vec3(0.5);
const float kUnseenSetback = 0.02;

void main() {
  vec4 color = texture(weighted_color, at.xy / at.z);
  bool is_seen = color.a > 0.0;
  picture = vec4(is_seen ? color.rgb / color.a : kUnseenGrey, 1.0);
  drawn_by = sensor;
  // To first order: window depth is 0.5 - 0.5 (A + B / z), and gl_FragCoord.w is 1 / -z.
  float back = is_seen ? 0.0 : -0.5 * kUnseenSetback * clip_from_view[0][3][2] * gl_FragCoord.w;
  gl_FragDepth = gl_FragCoord.z + back;
}
