// Fills the empty pixels of a level from the next coarser one. Runs from the coarsest level to the finest.

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray coarser;  // a layer for each eye
layout(rgba16f, binding = 0) uniform image2DArray level;

void main() {
  ivec3 pixel = ivec3(gl_GlobalInvocationID);
  if (any(greaterThanEqual(pixel, imageSize(level)))) return;
  if (imageLoad(level, pixel).a > 0.0) return;
  vec2 at = (vec2(pixel.xy) + 0.5) / vec2(2 * textureSize(coarser, 0).xy);
  imageStore(level, pixel, texture(coarser, vec3(at, float(pixel.z))));
}
