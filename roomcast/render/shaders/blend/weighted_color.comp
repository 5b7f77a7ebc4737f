// The colour a surface is drawn with, and how much it counts: that of the newest picture, or, where that differs only by
// noise, the mean of many. Colour has the depth grid's resolution or twice that.

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depth_in;
layout(binding = 2) uniform sampler2D color;
layout(binding = 3) uniform usampler2D seen;
layout(binding = 4) uniform sampler2D quality;
layout(binding = 5) uniform sampler2D background_color;  // its alpha is above 0 where it has a colour
layout(binding = 6) uniform sampler2D background;        // metres, readings
layout(rgba16f, binding = 0) writeonly uniform image2D weighted_color;  // rgb times quality, quality; or nothing

layout(location = 0) uniform bool is_background;
layout(location = 1) uniform vec3 gain;  // makes the sensor's colours agree with the others'

// Mean difference of the colours around a pixel: up to the first it is noise, from the second on something changed.
const float kNoise = 0.03;
const float kChange = 0.06;
// Colour was averaged over its pixels and will be interpolated between them; both take contrast from fine detail, which
// this gives back in part.
const float kSharpen = 0.9;

// The pixel of depth in which a pixel of colour lies. (Whole-number division is slow.)
ivec2 pixel_of(ivec2 at) { return textureSize(color, 0).x > textureSize(depth_in, 0).x ? at >> 1 : at; }

// 0: the newest colour shows something else than the mean of many; 1: the same.
float stillness(ivec2 at, ivec2 size, vec4 mean) {
  if (mean.a < 2.0) return 0.0;
  ivec2 pixel = pixel_of(at);
  vec2 known = texelFetch(background, pixel, 0).xy;
  float z = texelFetch(depth_in, pixel, 0).r;
  if (known.x == 0.0 || abs(z - known.x) > same_surface_gate(z)) return 0.0;
  vec3 difference = vec3(0.0);
  float count = 0.0;
  for (int y = max(at.y - 1, 0); y <= min(at.y + 1, size.y - 1); ++y) {
    for (int x = max(at.x - 1, 0); x <= min(at.x + 1, size.x - 1); ++x) {
      vec4 near = texelFetch(background_color, ivec2(x, y), 0);
      if (near.a < 2.0 || texelFetch(seen, pixel_of(ivec2(x, y)), 0).r == 0u) continue;
      difference += texelFetch(color, ivec2(x, y), 0).rgb - near.rgb;
      count += 1.0;
    }
  }
  vec3 change = abs(difference) / max(count, 1.0);
  return 1.0 - smoothstep(kNoise, kChange, max(change.r, max(change.g, change.b)));
}

// With 1, or 0 where there is none.
vec4 plain_color(ivec2 at, ivec2 size) {
  vec4 mean = texelFetch(background_color, at, 0);
  if (is_background) return vec4(mean.rgb, mean.a > 0.0 ? 1.0 : 0.0);
  if (texelFetch(seen, pixel_of(at), 0).r == 0u) return vec4(0.0);
  return vec4(mix(texelFetch(color, at, 0).rgb, mean.rgb, stillness(at, size, mean)), 1.0);
}

vec4 color_at(ivec2 at, ivec2 size) {
  vec4 here = plain_color(at, size);
  if (here.a == 0.0) return here;
  float z = texelFetch(depth_in, pixel_of(at), 0).r;
  vec4 around = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 near = at + ivec2(i < 2 ? 2 * i - 1 : 0, i < 2 ? 0 : 2 * i - 5);
    if (any(lessThan(near, ivec2(0))) || any(greaterThanEqual(near, size))) continue;
    if (abs(texelFetch(depth_in, pixel_of(near), 0).r - z) > 0.012 + 0.022 * z) continue;
    vec4 color = plain_color(near, size);
    around += vec4(color.rgb, 1.0) * color.a;
  }
  if (around.a < 4.0) return here;
  return vec4(clamp(here.rgb + kSharpen * (here.rgb - around.rgb / around.a), 0.0, 1.0), 1.0);
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(weighted_color);
  if (any(greaterThanEqual(at, size))) return;
  bool is_surface = texelFetch(depth_in, pixel_of(at), 0).r > 0.0;
  float counts = texture(quality, (vec2(at) + 0.5) / vec2(size)).r;
  vec4 shown = is_surface ? color_at(at, size) : vec4(0.0);
  imageStore(weighted_color, at, vec4(shown.rgb * gain, 1.0) * shown.a * counts);
}
