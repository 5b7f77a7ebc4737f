// Removes the points of a surface through which another sensor sees: in 3x3 pixels around the point, that sensor now
// reads something clearly farther.

layout(local_size_x = 16, local_size_y = 8) in;
layout(r32f, binding = 0) uniform image2D depth;
layout(binding = 1) uniform sampler2D rays;             // of this surface's sensor
layout(binding = 4) uniform usampler2D other_depth_mm;  // newest picture

layout(location = 0) uniform mat4 other_from_depth;
layout(location = 1) uniform vec4 other_focal_center;  // fx, fy, cx, cy
layout(location = 2) uniform vec3 other_radial;
layout(location = 3) uniform vec2 other_tangential;
layout(location = 4) uniform float other_widest_squared;  // the largest radius for which the lens's polynomial is valid

const float kBeyond_m = 0.06;
const float kBeyondPer_m = 0.02;
const float kNearest_m = 0.3;

// Brown-Conrady, as in geometry/camera_model.h.
vec2 projected(vec3 point) {
  vec2 xy = point.xy / point.z;
  float r2 = dot(xy, xy);
  float radial = 1.0 + r2 * (other_radial.x + r2 * (other_radial.y + r2 * other_radial.z));
  vec2 tangential = 2.0 * other_tangential * xy.x * xy.y + other_tangential.yx * (r2 + 2.0 * xy * xy);
  return other_focal_center.xy * (xy * radial + tangential) + other_focal_center.zw;
}

bool is_looked_through(vec3 point) {
  if (point.z < kNearest_m || dot(point.xy, point.xy) > other_widest_squared * point.z * point.z) return false;
  ivec2 at = ivec2(round(projected(point)));
  if (any(lessThan(at, ivec2(1))) || any(greaterThan(at, textureSize(other_depth_mm, 0) - 2))) return false;
  float beyond_mm = 1000.0 * (point.z + kBeyond_m + kBeyondPer_m * point.z);
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      if (float(texelFetch(other_depth_mm, at + ivec2(x, y), 0).r) < beyond_mm) return false;
    }
  }
  return true;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(depth)))) return;
  float z = imageLoad(depth, pixel).r;
  if (z == 0.0) return;
  vec3 point = vec3(texelFetch(rays, pixel, 0).xy * z, z);
  if (is_looked_through((other_from_depth * vec4(point, 1.0)).xyz)) imageStore(depth, pixel, vec4(0.0));
}
