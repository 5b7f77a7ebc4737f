// Distance in pixels to the next break of the surface along the row, 0 to kReach.

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depth_in;
layout(r8ui, binding = 0) writeonly uniform uimage2D in_row;

const int kReach = 5;
const float kBreak_m = 0.02;
const float kBreakPer_m = 0.025;

bool is_edge(ivec2 pixel, ivec2 size) {
  if (any(lessThan(pixel, ivec2(1))) || any(greaterThanEqual(pixel, size - 1))) return true;
  float z = texelFetch(depth_in, pixel, 0).r;
  if (z == 0.0) return true;
  float most = kBreak_m + kBreakPer_m * z;
  for (int i = 0; i < 4; ++i) {
    ivec2 step = ivec2(i < 2 ? 2 * i - 1 : 0, i < 2 ? 0 : 2 * i - 5);
    float near = texelFetch(depth_in, pixel + step, 0).r;
    if (near == 0.0 || abs(near - z) > most) return true;
  }
  return false;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(in_row);
  if (any(greaterThanEqual(pixel, size))) return;
  int distance = 0;
  while (distance < kReach && !is_edge(pixel + ivec2(distance, 0), size) &&
         !is_edge(pixel - ivec2(distance, 0), size)) {
    ++distance;
  }
  imageStore(in_row, pixel, uvec4(distance));
}
