in vec3 at;
in float counts;
layout(location = 0) out vec4 color_sum;  // rgb times weight, weight

void main() { color_sum = texture(weighted_color, at.xy / at.z) * counts; }
