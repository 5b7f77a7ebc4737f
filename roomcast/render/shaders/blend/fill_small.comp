// Gives a pixel without a reading the mean of its neighbours if most of them have a reading and all of those agree.

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depth_in;
layout(r32f, binding = 0) writeonly uniform image2D depth_out;

const int kEnough = 5;
const float kApart_m = 0.03;
const float kApartPer_m = 0.02;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(depth_out);
  if (any(greaterThanEqual(pixel, size))) return;
  float z = texelFetch(depth_in, pixel, 0).r;
  if (z == 0.0) {
    float sum = 0.0, least = 1.0e9, most = 0.0;
    int count = 0;
    for (int y = max(pixel.y - 1, 0); y <= min(pixel.y + 1, size.y - 1); ++y) {
      for (int x = max(pixel.x - 1, 0); x <= min(pixel.x + 1, size.x - 1); ++x) {
        float near = texelFetch(depth_in, ivec2(x, y), 0).r;
        if (near == 0.0) continue;
        sum += near;
        least = min(least, near);
        most = max(most, near);
        ++count;
      }
    }
    if (count >= kEnough && most - least < kApart_m + kApartPer_m * least) z = sum / float(count);
  }
  imageStore(depth_out, pixel, vec4(z));
}
