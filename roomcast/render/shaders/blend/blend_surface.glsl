// A cleaned surface of one sensor: put in front of the shaders that mix them. The bindings are those of
// surface_layer.cpp; the mesh's indices come from adaptive_mesh.comp.

layout(binding = 0) uniform sampler2D depth_m;  // 0: nothing to draw
layout(binding = 1) uniform sampler2D rays;
layout(binding = 2) uniform sampler2D weighted_color;  // in the depth grid: rgb times quality, quality
layout(binding = 4) uniform sampler2D quality;

// Indices of vertices name pixels; not by their number in the grid, for whole-number division is slow.
const int kColumnBits = 16;

uint index_of(ivec2 pixel) { return uint(pixel.y << kColumnBits | pixel.x); }

ivec2 pixel_of(int index) { return ivec2(index & (1 << kColumnBits) - 1, index >> kColumnBits); }

float z_at(ivec2 pixel) { return texelFetch(depth_m, pixel, 0).r; }
