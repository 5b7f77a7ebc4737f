// Classifies pixels without a reading in front of a remembered background: does the colour camera still see that
// background there? Shadows and exposure change a surface's brightness, so brightness may differ widely.

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D newest_m;
layout(binding = 2) uniform sampler2D color;             // newest; without a reading: seen at the surface read before
layout(binding = 5) uniform sampler2D background_color;  // alpha: number of samples in the mean
layout(binding = 6) uniform sampler2D background;        // metres, readings
layout(binding = 7) uniform sampler2D steadiness;        // update_background.comp
layout(r8ui, binding = 0) writeonly uniform uimage2D classes;

layout(location = 0) uniform int color_shift;  // log2 of colour pixels per depth pixel along an axis

const uint kUnclassified = 0u, kBackground = 1u, kForeground = 2u;
const float kEnoughReadings = 8.0;
const float kSteady = 0.8;  // below this, readings come and go: a missing one means nothing
const float kEnoughColors = 2.0;
// Limits of brightness (0..1, display values) as a share of the background's.
const float kDarkest = 0.75, kLightest = 1.35, kNoise = 0.03;
// Limits for colours divided by their brightness, used where there is enough light.
const float kMaxHueDistance = 0.15, kEnoughLight = 0.12;

float brightness(vec3 rgb) { return dot(rgb, vec3(1.0 / 3.0)); }

bool is_foreground(vec3 now, vec3 known) {
  float light_now = brightness(now), light_known = brightness(known);
  if (light_now < kDarkest * light_known - kNoise || light_now > kLightest * light_known + kNoise) return true;
  if (min(light_now, light_known) < kEnoughLight) return false;
  return distance(now / light_now, known / light_known) > kMaxHueDistance;
}

uint class_of(ivec2 pixel) {
  if (texelFetch(newest_m, pixel, 0).r > 0.0 || texelFetch(background, pixel, 0).y < kEnoughReadings) return kUnclassified;
  if (texelFetch(steadiness, pixel, 0).r < kSteady) return kUnclassified;
  vec3 now = vec3(0.0), known = vec3(0.0);
  for (int i = 0; i < 1 << (2 * color_shift); ++i) {
    ivec2 at = (pixel << color_shift) + ivec2(i & 1, i >> 1);
    vec4 mean = texelFetch(background_color, at, 0);
    if (mean.a < kEnoughColors) return kUnclassified;
    now += texelFetch(color, at, 0).rgb;
    known += mean.rgb;
  }
  float count = float(1 << (2 * color_shift));
  return is_foreground(now / count, known / count) ? kForeground : kBackground;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (all(lessThan(pixel, imageSize(classes)))) imageStore(classes, pixel, uvec4(class_of(pixel)));
}
