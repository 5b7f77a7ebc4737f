layout(location = 4) uniform int sensor;

in vec3 tint;
layout(location = 0) out vec4 picture;
layout(location = 1) out int drawn_by;

void main() {
  picture = vec4(tint, 1.0);
  drawn_by = sensor;
}
