// One sensor's newest pictures and where they are drawn. Put in front of every shader that reads a surface.
// The bindings and locations are those of sensor_surface.cpp and surface_view.cpp.

layout(binding = 0) uniform usampler2D depth_mm;  // 0 = no reading
layout(binding = 1) uniform sampler2D rays;       // undistorted (x/z, y/z); kNoRay and more = none
layout(binding = 2) uniform sampler2D color;      // in the depth grid, or two pixels for each of its own, both ways
layout(binding = 3) uniform usampler2D seen;      // 0 = the colour camera did not see this surface

layout(location = 0) uniform mat4 clip_from_view;
layout(location = 1) uniform mat4 view_from_depth;

const float kNoRay = 1.0e6;
const vec3 kUnseenGrey = vec3(0.5);
// A surface without a colour stands back by this share of its distance, so that another sensor that did see the
// colour of the same surface wins although its depth is as noisy.
const float kUnseenSetback = 0.02;
const vec4 kOutsideClip = vec4(2.0, 2.0, 2.0, 1.0);

int grid_width() { return textureSize(depth_mm, 0).x; }

ivec2 pixel_of(int index) { return ivec2(index % grid_width(), index / grid_width()); }

// Metres along the optical axis, 0 where there is nothing to draw.
float z_at(ivec2 pixel) {
  bool has_ray = texelFetch(rays, pixel, 0).x < kNoRay;
  return has_ray ? 0.001 * float(texelFetch(depth_mm, pixel, 0).r) : 0.0;
}

vec3 point_in_view(ivec2 pixel, float z) {
  vec2 ray = texelFetch(rays, pixel, 0).xy;
  return (view_from_depth * vec4(ray * z, z, 1.0)).xyz;
}

bool color_is_seen(ivec2 pixel) { return texelFetch(seen, pixel, 0).r != 0u; }

bool color_is_fine() { return textureSize(color, 0).x > grid_width(); }  // two pixels for one, both ways

vec3 tint_at(ivec2 pixel) {
  if (!color_is_seen(pixel)) return kUnseenGrey;
  if (!color_is_fine()) return texelFetch(color, pixel, 0).rgb;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; ++i) sum += texelFetch(color, 2 * pixel + ivec2(i & 1, i >> 1), 0).rgb;
  return 0.25 * sum;
}

// Adding a constant to clip.z moves a point back by a share of its distance, to first order: with
// ndc.z = -A - B/z, d(ndc.z)/dz = B/z^2, and a step of s*z changes clip.z = ndc.z * -z by -s*B.
vec4 clip_position(ivec2 pixel, vec3 in_view) {
  vec4 clip = clip_from_view * vec4(in_view, 1.0);
  if (!color_is_seen(pixel)) clip.z -= kUnseenSetback * clip_from_view[3][2];
  return clip;
}
