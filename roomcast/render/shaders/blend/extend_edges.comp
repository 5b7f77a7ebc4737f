// Extends surfaces at their edges: sensors lose readings at the edges of objects and on dark areas, so limbs come out
// too thin. A pixel without a reading takes the mean of its neighbours if all of them are on one surface, each continued
// to it. Things curve away where they end, so a surface is continued by its slope and somewhat farther back; a second
// pass takes the slope of the first.

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depth_in;
layout(r32f, binding = 0) writeonly uniform image2D depth_out;

const int kEnough = 2;
const float kApart_m = 0.012;
const float kApartPer_m = 0.022;
const float kBack_m = 0.01, kMaxBack_m = 0.04;  // per pixel

float apart(float z) { return kApart_m + kApartPer_m * z; }

// How much farther than `near` its surface is one pixel on; `before`: one pixel back, 0 without a reading.
float back(float near, float before) {
  float slope = before > 0.0 ? near - before : 0.0;
  return slope < apart(near) ? clamp(slope + kBack_m, 0.0, kMaxBack_m) : 0.0;
}

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
        ivec2 one_back = clamp(2 * ivec2(x, y) - pixel, ivec2(0), size - 1);
        sum += near + back(near, texelFetch(depth_in, one_back, 0).r);
        nearest = min(nearest, near);
        farthest = max(farthest, near);
        ++count;
      }
    }
    if (count >= kEnough && farthest - nearest < apart(nearest)) z = sum / float(count);
  }
  imageStore(depth_out, pixel, vec4(z));
}
