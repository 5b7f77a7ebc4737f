// Places an object that gives no reading (such as a dark monitor) where the colour camera sees something other than the
// remembered background. The object gets the distance of nearer readings around it, such as its frame or the person who
// carries it; without such readings it gets the background's distance.

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D newest_m;
layout(binding = 3) uniform usampler2D seen;
layout(binding = 4) uniform usampler2D classes;    // classify_foreground.comp
layout(binding = 6) uniform sampler2D background;  // metres, readings
layout(r32f, binding = 0) writeonly uniform image2D depth_out;
layout(r8ui, binding = 1) writeonly uniform uimage2D seen_out;  // where the newest colour is valid

const uint kUnclassified = 0u, kBackground = 1u, kForeground = 2u;
const int kAround = 2, kMinForeground = 13;  // of 25 pixels; smaller areas flicker at every edge
const int kReach = 64;
const float kBefore_m = 0.1, kBeforePer_m = 0.03;

// Number of pixels nearby that differ from the background, and number that match it.
ivec2 count_around(ivec2 pixel, ivec2 size) {
  int front = 0, back = 0;
  for (int y = max(pixel.y - kAround, 0); y <= min(pixel.y + kAround, size.y - 1); ++y) {
    for (int x = max(pixel.x - kAround, 0); x <= min(pixel.x + kAround, size.x - 1); ++x) {
      uint there = texelFetch(classes, ivec2(x, y), 0).r;
      front += there == kForeground ? 1 : 0;
      back += there == kBackground ? 1 : 0;
    }
  }
  return ivec2(front, back);
}

// The next reading in a direction: depth in metres, distance in pixels; 0 if there is none.
vec2 next_reading(ivec2 pixel, ivec2 step, ivec2 size) {
  for (int i = 1; i <= kReach; ++i) {
    ivec2 at = pixel + i * step;
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) break;
    float z = texelFetch(newest_m, at, 0).r;
    if (z > 0.0) return vec2(z, float(i) * length(vec2(step)));
  }
  return vec2(0.0);
}

// For an object with scattered readings: the mean depth of readings nearer than the background that agree in at least
// three corners around the pixel; 0 if there are none.
const int kNear = 7, kCorners = 3;

float between_readings(ivec2 pixel, ivec2 size) {
  float behind = texelFetch(background, pixel, 0).x;
  if (behind == 0.0) return 0.0;
  float before = behind - kBefore_m - kBeforePer_m * behind;
  int corners = 0;
  float sum = 0.0, nearest = 1.0e9, farthest = 0.0;
  for (int corner = 0; corner < 4; ++corner) {
    ivec2 away = 2 * ivec2(corner & 1, corner >> 1) - 1;
    for (int i = 0; i < kNear * kNear; ++i) {
      ivec2 at = pixel + away * ivec2(1 + i % kNear, 1 + i / kNear);
      if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) continue;
      float z = texelFetch(newest_m, at, 0).r;
      if (z == 0.0 || z > before) continue;
      sum += z;
      nearest = min(nearest, z);
      farthest = max(farthest, z);
      ++corners;
      break;
    }
  }
  bool agree = corners >= kCorners && farthest - nearest < kBefore_m + kBeforePer_m * farthest;
  return agree ? sum / float(corners) : 0.0;
}

float distance_around(ivec2 pixel, ivec2 size) {
  float behind = texelFetch(background, pixel, 0).x;
  float before = behind - kBefore_m - kBeforePer_m * behind;
  float sum = 0.0, weights = 0.0;
  for (int i = 0; i < 9; ++i) {
    ivec2 step = ivec2(i % 3, i / 3) - 1;
    if (step == ivec2(0)) continue;
    vec2 next = next_reading(pixel, step, size);
    if (next.x == 0.0 || next.x > before) continue;
    float weight = 1.0 / (next.y * next.y);
    sum += weight * next.x;
    weights += weight;
  }
  return weights > 0.0 ? sum / weights : behind;
}

// Depth of the object in front of the background; 0 if there is none.
float depth_of_foreground(ivec2 pixel, ivec2 size) {
  uint here = texelFetch(classes, pixel, 0).r;
  if (here == kUnclassified) return 0.0;
  ivec2 around = count_around(pixel, size);
  float between = 2 * around.x > around.y ? between_readings(pixel, size) : 0.0;
  if (between > 0.0) return between;
  bool is_patch = here == kForeground && around.x >= kMinForeground && around.x > 2 * around.y;
  return is_patch ? distance_around(pixel, size) : 0.0;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(depth_out);
  if (any(greaterThanEqual(pixel, size))) return;
  float z = texelFetch(newest_m, pixel, 0).r;
  uint is_seen = texelFetch(seen, pixel, 0).r;
  if (z == 0.0) {
    z = depth_of_foreground(pixel, size);
    if (z > 0.0) is_seen = 255u;
  }
  imageStore(depth_out, pixel, vec4(z));
  imageStore(seen_out, pixel, uvec4(is_seen));
}
