in vec3 at;
in vec2 depth_weight;
layout(location = 0) out vec4 color_sum;  // rgb times weight, weight
layout(location = 1) out vec2 depth_sum;  // metres times weight, weight

void main() {
  vec2 place = at.xy / at.z;
  color_sum = texture(weighted_color, place) * depth_weight.y;
  depth_sum = vec2(depth_weight.x, 1.0) * (texture(quality, place).r * depth_weight.y);
}
