// Inputs of a cleaned surface of one sensor. Comes before the shaders that draw such surfaces. The
// mesh's indices come from adaptive_mesh.comp.

layout(binding = 0) uniform sampler2D depth_m;  // 0: no surface
layout(binding = 1) uniform sampler2D rays;
layout(binding = 2) uniform sampler2D weighted_color;  // in the depth grid: rgb times quality, quality
layout(binding = 4) uniform sampler2D quality;

// A vertex index encodes a pixel as row and column bits: dividing a running index would be slow.
const int kColumnBits = 16;

uint index_of(ivec2 pixel) { return uint(pixel.y << kColumnBits | pixel.x); }

ivec2 pixel_of(int index) { return ivec2(index & (1 << kColumnBits) - 1, index >> kColumnBits); }

float z_at(ivec2 pixel) { return texelFetch(depth_m, pixel, 0).r; }
