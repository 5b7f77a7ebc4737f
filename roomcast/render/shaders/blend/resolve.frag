// The mixed picture: colours divided by their weights, and its depth. What lies among surfaces, and a surface whose
// colour nobody saw, takes the colour of its surroundings; what lies beside them stays as it was.

layout(binding = 0) uniform sampler2D color_sum;
layout(binding = 1) uniform sampler2D nearest_depth;
layout(binding = 2) uniform sampler2D surroundings;  // half the size
layout(binding = 3) uniform isampler2D nearest_sensor;
layout(binding = 4) uniform sampler2D narrow_coverage;  // of what surrounds a pixel closely
layout(binding = 5) uniform sampler2D wide_coverage;

layout(location = 1) uniform vec4 coverage_sizes;  // of narrow and wide, in the picture's pixels

layout(location = 2) uniform int unseen;           // Unseen of blend_renderer.h

const int kBackground = 0;
const int kSurroundings = 2;

layout(location = 0) out vec4 picture;
layout(location = 1) out int drawn_by;

// Of what no sensor sees; else 1 in small holes and in large ones with surfaces all around, 0 where surfaces end.
float is_filled() {
  if (unseen == kBackground) return 0.0;
  if (unseen == kSurroundings) return 1.0;
  float narrow = texture(narrow_coverage, gl_FragCoord.xy / coverage_sizes.xy).r;
  float wide = texture(wide_coverage, gl_FragCoord.xy / coverage_sizes.zw).r;
  return max(smoothstep(0.2, 0.35, narrow), smoothstep(0.45, 0.55, wide));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 color = texelFetch(color_sum, pixel, 0);
  float away = surface_m(texelFetch(nearest_depth, pixel, 0).r);
  bool is_surface = away > 0.0;
  float shown = is_surface ? 1.0 : is_filled();
  if (shown == 0.0) discard;
  if (color.a <= 0.0 && unseen != kBackground) color = texture(surroundings, gl_FragCoord.xy / vec2(2 * textureSize(surroundings, 0)));
  if (color.a <= 0.0 && !is_surface) discard;  // there is no colour anywhere
  picture = vec4(color.a > 0.0 ? color.rgb / color.a : vec3(0.5), shown);
  drawn_by = is_surface ? texelFetch(nearest_sensor, pixel, 0).r : -1;
  gl_FragDepth = is_surface ? 0.5 + 0.5 * (depth_from_z.x + depth_from_z.y / away) : 1.0;
}
