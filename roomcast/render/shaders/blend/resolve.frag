// The mixed picture: colours divided by their weights, holes filled from what surrounds them, and its depth.

layout(binding = 0) uniform sampler2D color_sum;
layout(binding = 1) uniform sampler2D depth_sum;
layout(binding = 2) uniform sampler2D surroundings;  // half the size
layout(binding = 3) uniform isampler2D nearest_sensor;

layout(location = 0) uniform vec2 depth_from_z;  // ndc depth = x + y / z

layout(location = 0) out vec4 picture;
layout(location = 1) out int drawn_by;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 color = texelFetch(color_sum, pixel, 0);
  vec2 depth = texelFetch(depth_sum, pixel, 0).rg;
  bool is_surface = depth.y > 0.0;
  if (color.a <= 0.0) color = texture(surroundings, gl_FragCoord.xy / vec2(2 * textureSize(surroundings, 0)));
  if (color.a <= 0.0 && !is_surface) discard;
  picture = vec4(color.a > 0.0 ? color.rgb / color.a : vec3(0.5), 1.0);
  drawn_by = is_surface ? texelFetch(nearest_sensor, pixel, 0).r : -1;
  gl_FragDepth = is_surface ? 0.5 + 0.5 * (depth_from_z.x + depth_from_z.y * depth.y / depth.x) : 1.0;
}
