// Final picture: colours divided by their weights. Holes between surfaces, and surfaces without a colour, take the
// surrounding colour; pixels outside all surfaces keep the background.

layout(binding = 0) uniform sampler2D color_sum;
layout(binding = 1) uniform sampler2D nearest_depth;
layout(binding = 2) uniform sampler2DArray surroundings;  // half the size, one layer per eye; alpha: opacity in holes

layout(location = 0) out vec4 picture;

vec3 in_layer_of_eye() {
  ivec3 layers = textureSize(surroundings, 0);
  float eye_width = float(textureSize(color_sum, 0).x / layers.z);
  float eye = floor(gl_FragCoord.x / eye_width);
  return vec3((gl_FragCoord.xy - vec2(eye * eye_width, 0.0)) / vec2(2 * layers.xy), eye);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 color = texelFetch(color_sum, pixel, 0);
  picture = vec4(color.rgb / color.a, 1.0);
  if (color.a <= 0.0) {
    picture = texture(surroundings, in_layer_of_eye());
    if (texelFetch(nearest_depth, pixel, 0).r < 1.0) picture.a = 1.0;
    if (picture.a == 0.0) discard;
  }
}
