// Half the size: sums of colours with their weights (push-pull, Gortler et al. 1996), and how much is covered. The far
// counts more: what fills a hole beside a person is the wall behind.

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D color_sum;  // of the mixed picture, or the finer level
layout(binding = 1) uniform sampler2D nearest_depth;
layout(binding = 2) uniform sampler2D coverage;  // of the finer level
layout(rgba16f, binding = 0) writeonly uniform image2D coarser;
layout(r16f, binding = 1) writeonly uniform image2D coarser_coverage;

layout(location = 0) uniform bool from_picture;
layout(location = 3) uniform vec2 depth_from_z;  // ndc depth = x + y / z

const float kFar_m = 4.0;

// Along the eye's axis.
float surface_m(float depth) { return depth_from_z.y / (2.0 * depth - 1.0 - depth_from_z.x); }

vec4 weighted(vec4 sum, float depth) {
  if (sum.a <= 0.0) return vec4(0.0);
  float far = min(surface_m(depth) / kFar_m, 1.0);
  return vec4(sum.rgb / sum.a, 1.0) * (far * far * far + 0.001);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(coarser)))) return;
  ivec2 size = textureSize(color_sum, 0);
  vec4 color = vec4(0.0);
  float share = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 finer = 2 * pixel + ivec2(i & 1, i >> 1);
    if (any(greaterThanEqual(finer, size))) continue;
    vec4 sum = texelFetch(color_sum, finer, 0);
    if (from_picture) {
      float depth = texelFetch(nearest_depth, finer, 0).r;
      color += 0.25 * weighted(sum, depth);
      share += depth < 1.0 ? 0.25 : 0.0;
    } else {
      color += 0.25 * sum;
      share += 0.25 * texelFetch(coverage, finer, 0).r;
    }
  }
  imageStore(coarser, pixel, color);
  imageStore(coarser_coverage, pixel, vec4(share));
}
