// Weight of a pixel when surfaces of several sensors are mixed. It grows with nearness, with an angle of view closer to
// the normal, and with distance from the next break, where depth and colour mix both sides of the break.

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depth_in;
layout(binding = 1) uniform sampler2D rays;
layout(binding = 4) uniform usampler2D edge_in_row;
layout(r16f, binding = 0) writeonly uniform image2D quality;

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

// Vector from the previous point to the next one; 0 if either is missing.
vec3 across(ivec2 pixel, ivec2 step, ivec2 size) {
  vec3 a = point_at(pixel - step, size), b = point_at(pixel + step, size);
  return a.z > 0.0 && b.z > 0.0 ? b - a : vec3(0.0);
}

// Cosine of the angle between the ray and the surface's normal; 1 if the normal is unknown.
float facing(ivec2 pixel, ivec2 size, vec3 point) {
  vec3 right = across(pixel, ivec2(1, 0), size) + across(pixel, ivec2(2, 0), size);
  vec3 down = across(pixel, ivec2(0, 1), size) + across(pixel, ivec2(0, 2), size);
  vec3 normal = cross(right, down);
  float size2 = dot(normal, normal);
  return size2 > 0.0 ? abs(dot(normal, normalize(point))) * inversesqrt(size2) : 1.0;
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
}
