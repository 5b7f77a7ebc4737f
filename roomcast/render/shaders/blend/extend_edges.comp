// Extends surfaces at their edges: sensors lose readings at the edges of objects and on dark areas, so limbs come out
// too thin. A pixel without a reading takes the mean of its neighbours if all of them are on one surface.

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depth_in;
layout(r32f, binding = 0) writeonly uniform image2D depth_out;

const int kEnough = 2;
const float kApart_m = 0.012;
const float kApartPer_m = 0.022;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(depth_out);
  if (any(greaterThanEqual(pixel, size))) return;
  float z = texelFetch(depth_in, pixel, 0).r;
  if (z == 0.0) {
    float sum = 0.0, nearest = 1.0e9, farthest = 0.0;
    int count = 0;
    for (int y = max(pixel.y - 1, 0); y <= min(pixel.y + 1, size.y - 1); ++y) {
      for (int x = max(pixel.x - 1, 0); x <= min(pixel.x + 1, size.x - 1); ++x) {
        float near = texelFetch(depth_in, ivec2(x, y), 0).r;
        if (near == 0.0) continue;
        sum += near;
        nearest = min(nearest, near);
        farthest = max(farthest, near);
        ++count;
      }
    }
    if (count >= kEnough && farthest - nearest < kApart_m + kApartPer_m * nearest) z = sum / float(count);
  }
  imageStore(depth_out, pixel, vec4(z));
}
