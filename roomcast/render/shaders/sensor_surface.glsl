// One sensor's newest pictures. Comes before every shader that reads them.

layout(binding = 0) uniform usampler2D depth_mm;  // 0: no reading
layout(binding = 1) uniform sampler2D rays;       // undistorted (x/z, y/z); kNoRay or more: none
layout(binding = 2) uniform sampler2D color;      // at the depth grid's resolution, or twice that along each axis
layout(binding = 3) uniform usampler2D seen;      // 0: the colour camera did not see this surface

const float kNoRay = 1.0e6;
const vec3 kUnseenGrey = vec3(0.5);

int grid_width() { return textureSize(depth_mm, 0).x; }

ivec2 pixel_of(int index) { return ivec2(index % grid_width(), index / grid_width()); }

// Metres along the optical axis, 0 without a surface.
float z_at(ivec2 pixel) {
  bool has_ray = texelFetch(rays, pixel, 0).x < kNoRay;
  return has_ray ? 0.001 * float(texelFetch(depth_mm, pixel, 0).r) : 0.0;
}

bool color_is_seen(ivec2 pixel) { return texelFetch(seen, pixel, 0).r != 0u; }

bool color_is_fine() { return textureSize(color, 0).x > grid_width(); }  // twice the depth grid's resolution

vec3 tint_at(ivec2 pixel) {
  if (!color_is_seen(pixel)) return kUnseenGrey;
  if (!color_is_fine()) return texelFetch(color, pixel, 0).rgb;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; ++i) sum += texelFetch(color, 2 * pixel + ivec2(i & 1, i >> 1), 0).rgb;
  return 0.25 * sum;
}
