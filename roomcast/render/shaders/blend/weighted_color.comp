// The sharpened colour of a surface, multiplied by its weight.

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depth_in;
layout(binding = 2) uniform sampler2D color;  // alpha > 0 where there is a colour
layout(binding = 4) uniform sampler2D quality;
layout(rgba16f, binding = 0) writeonly uniform image2D weighted_color;  // rgb times quality, quality; or 0

layout(location = 0) uniform int color_shift;  // log2 of colour pixels per depth pixel along an axis
layout(location = 1) uniform vec3 gain;  // matches the sensor's colours to the others'

// Colour was averaged over its pixels and will be interpolated between them; both reduce the contrast of fine detail.
// Sharpening restores part of it, more at the depth grid's resolution, where the loss is larger.
const float kSharpen = 0.9;
const float kSharpenFine = 0.15;

// Returns `here` unchanged at the surface's edges and where a neighbour has no colour.
vec3 sharpened(vec3 here, float z, ivec2 at, ivec2 size) {
  vec3 around = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 near = at + ivec2(i < 2 ? 2 * i - 1 : 0, i < 2 ? 0 : 2 * i - 5);
    if (any(lessThan(near, ivec2(0))) || any(greaterThanEqual(near, size))) return here;
    if (abs(texelFetch(depth_in, near >> color_shift, 0).r - z) > 0.012 + 0.022 * z) return here;
    vec4 there = texelFetch(color, near, 0);
    if (there.a == 0.0) return here;
    around += there.rgb;
  }
  return clamp(here + (color_shift == 0 ? kSharpen : kSharpenFine) * (here - around / 4.0), 0.0, 1.0);
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(weighted_color);
  if (any(greaterThanEqual(at, size))) return;
  float z = texelFetch(depth_in, at >> color_shift, 0).r;
  vec4 here = texelFetch(color, at, 0);
  vec4 shown = vec4(0.0);
  if (z > 0.0 && here.a > 0.0) {
    float counts = texture(quality, (vec2(at) + 0.5) / vec2(size)).r;
    shown = vec4(sharpened(here.rgb, z, at, size) * gain, 1.0) * counts;
  }
  imageStore(weighted_color, at, shown);
}
