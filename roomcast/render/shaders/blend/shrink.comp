// Halves the size: sums of colours with their weights (push-pull, Gortler et al. 1996), and coverage.

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray finer_color;  // a layer for each eye
layout(binding = 1) uniform sampler2DArray finer_coverage;
layout(rgba16f, binding = 0) writeonly uniform image2DArray coarser;
layout(r16f, binding = 1) writeonly uniform image2DArray coarser_coverage;

void main() {
  ivec3 pixel = ivec3(gl_GlobalInvocationID);
  if (any(greaterThanEqual(pixel, imageSize(coarser)))) return;
  ivec2 size = textureSize(finer_color, 0).xy;
  vec4 color = vec4(0.0);
  float share = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec3 finer = ivec3(2 * pixel.xy + ivec2(i & 1, i >> 1), pixel.z);
    if (any(greaterThanEqual(finer.xy, size))) continue;
    color += 0.25 * texelFetch(finer_color, finer, 0);
    share += 0.25 * texelFetch(finer_coverage, finer, 0).r;
  }
  imageStore(coarser, pixel, color);
  imageStore(coarser_coverage, pixel, vec4(share));
}
