// Colour for pixels that no sensor sees: the surrounding colour and its opacity. Half the size of the picture, one
// layer per eye.

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray coarser;          // colours times weights, weights
layout(binding = 3) uniform sampler2DArray narrow_coverage;  // in a small area around the pixel; below: a large one
layout(binding = 4) uniform sampler2DArray wide_coverage;
layout(rgba16f, binding = 0) uniform image2DArray level;  // in: as `coarser`; out: colour, opacity

layout(location = 1) uniform vec4 coverage_sizes;  // sizes of both coverages in pixels of this level
layout(location = 2) uniform int unseen;           // Unseen of blend_renderer.h

const int kBackground = 0;
const int kSurroundings = 2;
const vec4 kUnseenGrey = vec4(vec3(0.5), 0.0);

// 1 in small holes and in large holes enclosed by surfaces, 0 beyond the edges of surfaces.
float is_filled(vec2 at, float eye) {
  if (unseen == kSurroundings) return 1.0;
  float narrow = texture(narrow_coverage, vec3(at / coverage_sizes.xy, eye)).r;
  float wide = texture(wide_coverage, vec3(at / coverage_sizes.zw, eye)).r;
  return max(smoothstep(0.2, 0.35, narrow), smoothstep(0.45, 0.55, wide));
}

void main() {
  ivec3 pixel = ivec3(gl_GlobalInvocationID);
  if (any(greaterThanEqual(pixel, imageSize(level)))) return;
  vec2 at = vec2(pixel.xy) + 0.5;
  float eye = float(pixel.z);
  vec4 color = imageLoad(level, pixel);
  if (color.a == 0.0) color = texture(coarser, vec3(at / vec2(2 * textureSize(coarser, 0).xy), eye));
  bool is_shown = unseen != kBackground && color.a > 0.0;  // else no pixel has a colour
  imageStore(level, pixel, is_shown ? vec4(color.rgb / color.a, is_filled(at, eye)) : kUnseenGrey);
}
