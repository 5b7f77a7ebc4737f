// Where a level has nothing, what the next coarser one has: from the coarsest to the finest.

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D coarser;
layout(rgba16f, binding = 0) uniform image2D level;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(level)))) return;
  if (imageLoad(level, pixel).a > 0.0) return;
  imageStore(level, pixel, texture(coarser, (vec2(pixel) + 0.5) / vec2(2 * textureSize(coarser, 0))));
}
