in vec4 weighted_color;
in vec2 weighted_depth;
layout(location = 0) out vec4 color_sum;
layout(location = 1) out vec2 depth_sum;

void main() {
  color_sum = weighted_color;
  depth_sum = weighted_depth;
}
