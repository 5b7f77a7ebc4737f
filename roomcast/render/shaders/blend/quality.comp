// How much a pixel counts when surfaces of several sensors are mixed: the more, the closer it is, the more squarely it
// was seen, and the farther from the next break of the surface, where depth and colour mix what lies on both sides.
// Also the colour it counts with: that of the newest picture, or, where that differs only by noise, the mean of many.

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depth_in;
layout(binding = 1) uniform sampler2D rays;
layout(binding = 2) uniform sampler2D color;
layout(binding = 3) uniform usampler2D seen;
layout(binding = 4) uniform usampler2D edge_in_row;
layout(binding = 5) uniform sampler2D background_color;  // its alpha is above 0 where it has a colour
layout(binding = 6) uniform sampler2D background;        // metres, readings
layout(r16f, binding = 0) writeonly uniform image2D quality;
layout(rgba16f, binding = 1) writeonly uniform image2D weighted_color;  // rgb times quality, quality; or nothing

layout(location = 0) uniform bool is_background;
layout(location = 1) uniform vec3 gain;  // makes the sensor's colours agree with the others'

// Mean difference of the colours around a pixel: up to the first it is noise, from the second on something changed.
const float kNoise = 0.03;
const float kChange = 0.06;

const int kReach = 5;

float edge_distance(ivec2 pixel, ivec2 size) {
  float nearest = float(kReach * kReach);
  for (int y = max(pixel.y - kReach, 0); y <= min(pixel.y + kReach, size.y - 1); ++y) {
    float across = float(texelFetch(edge_in_row, ivec2(pixel.x, y), 0).r);
    float down = float(y - pixel.y);
    nearest = min(nearest, across * across + down * down);
  }
  return sqrt(nearest);
}

vec3 point_at(ivec2 pixel, ivec2 size) {
  pixel = clamp(pixel, ivec2(0), size - 1);
  float z = texelFetch(depth_in, pixel, 0).r;
  return vec3(texelFetch(rays, pixel, 0).xy * z, z);
}

// From the point before to the point behind, 0 where either is missing.
vec3 across(ivec2 pixel, ivec2 step, ivec2 size) {
  vec3 a = point_at(pixel - step, size), b = point_at(pixel + step, size);
  return a.z > 0.0 && b.z > 0.0 ? b - a : vec3(0.0);
}

// Of the angle between the ray and the surface's normal; 1 where there is no normal to be had.
float facing(ivec2 pixel, ivec2 size, vec3 point) {
  vec3 right = across(pixel, ivec2(1, 0), size) + across(pixel, ivec2(2, 0), size);
  vec3 down = across(pixel, ivec2(0, 1), size) + across(pixel, ivec2(0, 2), size);
  vec3 normal = cross(right, down);
  float size2 = dot(normal, normal);
  return size2 > 0.0 ? abs(dot(normal, normalize(point))) * inversesqrt(size2) : 1.0;
}

// 0: the newest colour shows something else than the mean of many; 1: the same.
float stillness(ivec2 pixel, ivec2 size, vec4 mean) {
  if (mean.a < 2.0) return 0.0;
  vec2 known = texelFetch(background, pixel, 0).xy;
  float z = texelFetch(depth_in, pixel, 0).r;
  if (known.x == 0.0 || abs(z - known.x) > same_surface_gate(z)) return 0.0;
  vec3 difference = vec3(0.0);
  float count = 0.0;
  for (int y = max(pixel.y - 1, 0); y <= min(pixel.y + 1, size.y - 1); ++y) {
    for (int x = max(pixel.x - 1, 0); x <= min(pixel.x + 1, size.x - 1); ++x) {
      vec4 near = texelFetch(background_color, ivec2(x, y), 0);
      if (near.a < 2.0 || texelFetch(seen, ivec2(x, y), 0).r == 0u) continue;
      difference += texelFetch(color, ivec2(x, y), 0).rgb - near.rgb;
      count += 1.0;
    }
  }
  vec3 change = abs(difference) / max(count, 1.0);
  return 1.0 - smoothstep(kNoise, kChange, max(change.r, max(change.g, change.b)));
}

// With 1, or 0 where there is none.
vec4 plain_color(ivec2 pixel, ivec2 size) {
  vec4 mean = texelFetch(background_color, pixel, 0);
  if (is_background) return vec4(mean.rgb, mean.a > 0.0 ? 1.0 : 0.0);
  if (texelFetch(seen, pixel, 0).r == 0u) return vec4(0.0);
  return vec4(mix(texelFetch(color, pixel, 0).rgb, mean.rgb, stillness(pixel, size, mean)), 1.0);
}

// Colour was averaged over a depth pixel and will be interpolated between them; both take contrast from fine detail,
// which this gives back in part.
const float kSharpen = 0.9;

vec4 color_at(ivec2 pixel, ivec2 size) {
  vec4 here = plain_color(pixel, size);
  if (here.a == 0.0) return here;
  float z = texelFetch(depth_in, pixel, 0).r;
  vec4 around = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 near = pixel + ivec2(i < 2 ? 2 * i - 1 : 0, i < 2 ? 0 : 2 * i - 5);
    if (any(lessThan(near, ivec2(0))) || any(greaterThanEqual(near, size))) continue;
    if (abs(texelFetch(depth_in, near, 0).r - z) > 0.012 + 0.022 * z) continue;
    vec4 color = plain_color(near, size);
    around += vec4(color.rgb, 1.0) * color.a;
  }
  if (around.a < 4.0) return here;
  return vec4(clamp(here.rgb + kSharpen * (here.rgb - around.rgb / around.a), 0.0, 1.0), 1.0);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(quality);
  if (any(greaterThanEqual(pixel, size))) return;
  vec3 point = point_at(pixel, size);
  float counts = 0.0;
  if (point.z > 0.0) {
    float cosine = facing(pixel, size, point);
    float inside = min((edge_distance(pixel, size) + 0.3) / float(kReach), 1.0);
    counts = (0.05 + cosine * cosine) / (point.z * point.z) * inside;
  }
  imageStore(quality, pixel, vec4(counts));
  vec4 shown = counts > 0.0 ? color_at(pixel, size) : vec4(0.0);
  imageStore(weighted_color, pixel, vec4(shown.rgb * gain, 1.0) * shown.a * counts);
}
