// Light from above and from over the shoulder; a beam is lit by itself.

layout(location = 4) uniform vec3 color;
layout(location = 5) uniform float own_light;

in vec3 world_normal;
layout(location = 0) out vec4 picture;

const vec3 lamp = normalize(vec3(1.0, 3.0, 2.0));

void main() {
  vec3 normal = normalize(world_normal);
  float sky = mix(0.45, 0.75, 0.5 + 0.5 * normal.y);
  float light = sky + 0.45 * max(dot(normal, lamp), 0.0);
  picture = vec4(color * mix(light, 1.0, own_light), 1.0);
}
