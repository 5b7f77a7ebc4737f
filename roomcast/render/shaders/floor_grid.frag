// Thin lines every metre, fading with distance.

layout(location = 4) uniform float reach_m;
layout(location = 5) uniform vec4 line;  // colour and opacity

in vec2 floor_xz;
flat in vec2 eye_xz;
layout(location = 0) out vec4 picture;

void main() {
  vec2 pixel_m = max(fwidth(floor_xz), vec2(1.0e-6));
  vec2 off_line_px = abs(fract(floor_xz - 0.5) - 0.5) / pixel_m;
  vec2 coverage = clamp(1.2 - off_line_px, 0.0, 1.0);
  // Fades out lines that are less than a few pixels apart, which would flicker.
  coverage *= clamp(0.25 / pixel_m - 1.0, 0.0, 1.0);
  float fade = clamp(1.0 - distance(eye_xz, floor_xz) / reach_m, 0.0, 1.0);
  picture = vec4(line.rgb, line.a * max(coverage.x, coverage.y) * fade);
}
