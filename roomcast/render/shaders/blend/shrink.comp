// Half the size: sums of colours with their weights (push-pull, Gortler et al. 1996), and how much is covered. The far
// counts more: what fills a hole beside a person is the wall behind.

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D color_sum;  // of the mixed picture, or the finer level
layout(binding = 1) uniform sampler2D nearest_depth;
layout(binding = 2) uniform sampler2D coverage;  // of the finer level
layout(rgba16f, binding = 0) writeonly uniform image2D coarser;
layout(r16f, binding = 1) writeonly uniform image2D coarser_coverage;

layout(location = 0) uniform bool from_picture;

const float kFar_m = 4.0;

vec4 weighted(ivec2 pixel) {
  ivec2 size = textureSize(color_sum, 0);
  if (any(greaterThanEqual(pixel, size))) return vec4(0.0);
  vec4 sum = texelFetch(color_sum, pixel, 0);
  if (!from_picture) return sum;
  if (sum.a <= 0.0) return vec4(0.0);
  float far = min(surface_m(texelFetch(nearest_depth, pixel, 0).r) / kFar_m, 1.0);
  return vec4(sum.rgb / sum.a, 1.0) * (far * far * far + 0.001);
}

float covered(ivec2 pixel) {
  ivec2 size = textureSize(color_sum, 0);
  if (any(greaterThanEqual(pixel, size))) return 0.0;
  if (!from_picture) return texelFetch(coverage, pixel, 0).r;
  return texelFetch(nearest_depth, pixel, 0).r < 1.0 ? 1.0 : 0.0;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(coarser)))) return;
  vec4 color = vec4(0.0);
  float share = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 finer = 2 * pixel + ivec2(i & 1, i >> 1);
    color += 0.25 * weighted(finer);
    share += 0.25 * covered(finer);
  }
  imageStore(coarser, pixel, color);
  imageStore(coarser_coverage, pixel, vec4(share));
}
