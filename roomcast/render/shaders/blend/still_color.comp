// Colour of a live surface: the newest colour, or the mean over time where the two differ only by noise.

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depth_in;
layout(binding = 2) uniform sampler2D color;
layout(binding = 3) uniform usampler2D seen;
layout(binding = 5) uniform sampler2D background_color;  // alpha: number of samples in the mean
layout(binding = 6) uniform sampler2D background;        // metres, readings
layout(rgba16f, binding = 0) writeonly uniform image2D still_color;  // alpha: 1, or 0 without a colour

layout(location = 0) uniform int color_shift;  // log2 of colour pixels per depth pixel along an axis

// Mean colour difference around a pixel: below kNoise it is noise, above kChange the scene has changed.
const float kNoise = 0.03;
const float kChange = 0.06;

// 0: the newest colour differs from the mean; 1: it is the same.
float stillness(ivec2 at, ivec2 size, vec4 mean) {
  if (mean.a < 2.0) return 0.0;
  ivec2 pixel = at >> color_shift;
  vec2 known = texelFetch(background, pixel, 0).xy;
  float z = texelFetch(depth_in, pixel, 0).r;
  if (known.x == 0.0 || abs(z - known.x) > same_surface_gate(z)) return 0.0;
  vec3 difference = vec3(0.0);
  float count = 0.0;
  for (int y = max(at.y - 1, 0); y <= min(at.y + 1, size.y - 1); ++y) {
    for (int x = max(at.x - 1, 0); x <= min(at.x + 1, size.x - 1); ++x) {
      vec4 near = texelFetch(background_color, ivec2(x, y), 0);
      if (near.a < 2.0 || texelFetch(seen, ivec2(x, y) >> color_shift, 0).r == 0u) continue;
      difference += texelFetch(color, ivec2(x, y), 0).rgb - near.rgb;
      count += 1.0;
    }
  }
  vec3 change = abs(difference) / max(count, 1.0);
  return 1.0 - smoothstep(kNoise, kChange, max(change.r, max(change.g, change.b)));
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(still_color);
  if (any(greaterThanEqual(at, size))) return;
  vec4 shown = vec4(0.0);
  if (texelFetch(seen, at >> color_shift, 0).r != 0u) {
    vec4 mean = texelFetch(background_color, at, 0);
    shown = vec4(mix(texelFetch(color, at, 0).rgb, mean.rgb, stillness(at, size, mean)), 1.0);
  }
  imageStore(still_color, at, shown);
}
