layout(binding = 0) uniform sampler2D letters;
layout(location = 3) uniform vec4 color;
layout(location = 4) uniform vec2 plate_m;  // half of its width and height; 0: a letter

in vec2 uv;
layout(location = 0) out vec4 picture;

// Coverage of a plate with round ends.
float plate_coverage() {
  vec2 off = abs(uv) * plate_m - vec2(plate_m.x - plate_m.y, 0.0);
  float distance_m = length(vec2(max(off.x, 0.0), off.y)) - plate_m.y;
  return clamp(0.5 - distance_m / max(fwidth(distance_m), 1.0e-6), 0.0, 1.0);
}

void main() {
  float coverage = plate_m.y > 0.0 ? plate_coverage() : texture(letters, uv).r;
  if (coverage < 0.01) discard;
  picture = vec4(color.rgb, color.a * coverage);
}
