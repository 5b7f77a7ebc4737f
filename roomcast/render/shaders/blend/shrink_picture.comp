// The mixed picture at half its size, one layer per eye: colours with weights, and coverage. Far surfaces weigh more,
// because a hole next to a person should show the wall behind.

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D color_sum;  // the eyes' parts side by side
layout(binding = 1) uniform sampler2D nearest_depth;
layout(rgba16f, binding = 0) writeonly uniform image2DArray coarser;
layout(r16f, binding = 1) writeonly uniform image2DArray coarser_coverage;

layout(location = 0) uniform vec2 depth_from_z;  // ndc depth = x + y / z

const float kFar_m = 4.0;

// Distance along the eye's axis.
float surface_m(float depth) { return depth_from_z.y / (2.0 * depth - 1.0 - depth_from_z.x); }

vec4 weighted(vec4 sum, float depth) {
  if (sum.a <= 0.0) return vec4(0.0);
  float far = min(surface_m(depth) / kFar_m, 1.0);
  return vec4(sum.rgb / sum.a, 1.0) * (far * far * far + 0.001);
}

void main() {
  ivec3 pixel = ivec3(gl_GlobalInvocationID);
  ivec3 layers = imageSize(coarser);
  if (any(greaterThanEqual(pixel, layers))) return;
  ivec2 size = textureSize(color_sum, 0) / ivec2(layers.z, 1);  // of one eye's part
  vec4 color = vec4(0.0);
  float share = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 finer = 2 * pixel.xy + ivec2(i & 1, i >> 1);
    if (any(greaterThanEqual(finer, size))) continue;
    finer.x += pixel.z * size.x;
    float depth = texelFetch(nearest_depth, finer, 0).r;
    color += 0.25 * weighted(texelFetch(color_sum, finer, 0), depth);
    share += depth < 1.0 ? 0.25 : 0.0;
  }
  imageStore(coarser, pixel, color);
  imageStore(coarser_coverage, pixel, vec4(share));
}
