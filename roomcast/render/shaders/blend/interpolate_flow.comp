// The velocity of each pixel of a cleaned surface from the motion of its cells of kCellPixels x kCellPixels pixels: between
// the four cells around the pixel, of those whose surface this is; none where nothing moves in the pixel's own cell.

layout(local_size_x = 16, local_size_y = 8) in;
// Metres per second in the sensor's frame; surfaces nearer than the last number move, in metres.
layout(binding = 0) uniform sampler2D cells;
layout(binding = 1) uniform sampler2D depth_m;
layout(rgba16f, binding = 0) writeonly uniform image2D velocities_out;

const int kCellPixels = 4;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(velocities_out)))) return;
  float z = texelFetch(depth_m, pixel, 0).r;
  bool may_move = z > 0.0 && texelFetch(cells, pixel / kCellPixels, 0).w != 0.0;
  vec2 at = (vec2(pixel) + 0.5) / float(kCellPixels) - 0.5;
  ivec2 first = ivec2(floor(at)), last = textureSize(cells, 0) - 1;
  vec2 part = at - vec2(first);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < (may_move ? 4 : 0); ++i) {
    ivec2 beside = ivec2(i & 1, i >> 1);
    vec4 cell = texelFetch(cells, clamp(first + beside, ivec2(0), last), 0);
    vec2 share = mix(1.0 - part, part, vec2(beside));
    if (z < cell.w) sum += vec4(cell.xyz, 1.0) * share.x * share.y;
  }
  imageStore(velocities_out, pixel, sum.a > 0.0 ? vec4(sum.xyz / sum.a, 0.0) : vec4(0.0));
}
