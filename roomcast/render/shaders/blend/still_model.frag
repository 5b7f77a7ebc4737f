// The room's model where no sensor shows a surface: its colour with the weight 1.

layout(binding = 0) uniform sampler2D shown_depth;  // what sensors show; 1: nothing

in vec3 color;
layout(location = 0) out vec4 color_sum;

void main() {
  if (texelFetch(shown_depth, ivec2(gl_FragCoord.xy), 0).r < 1.0) discard;
  color_sum = vec4(color, 1.0);
}
