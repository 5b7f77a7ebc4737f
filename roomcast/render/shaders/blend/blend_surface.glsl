// A cleaned surface of one sensor: put in front of the shaders that mix them. The bindings and locations are those of
// surface_layer.cpp; the mesh's indices come from adaptive_mesh.comp.

layout(binding = 0) uniform sampler2D depth_m;  // 0: nothing to draw
layout(binding = 1) uniform sampler2D rays;
layout(binding = 2) uniform sampler2D weighted_color;  // in the depth grid: rgb times quality, quality
layout(binding = 4) uniform sampler2D quality;

layout(location = 0) uniform mat4 clip_from_view;
layout(location = 1) uniform mat4 view_from_depth;
layout(location = 2) uniform float setback_m;  // along the eye's ray
layout(location = 3) uniform int sensor;

// Indices of vertices name pixels; not by their number in the grid, for whole-number division is slow.
const int kColumnBits = 16;

uint index_of(ivec2 pixel) { return uint(pixel.y << kColumnBits | pixel.x); }

ivec2 pixel_of(int index) { return ivec2(index & (1 << kColumnBits) - 1, index >> kColumnBits); }

float z_at(ivec2 pixel) { return texelFetch(depth_m, pixel, 0).r; }

vec3 point_in_view(ivec2 pixel) {
  float z = z_at(pixel);
  vec3 point = (view_from_depth * vec4(texelFetch(rays, pixel, 0).xy * z, z, 1.0)).xyz;
  return point * (1.0 + setback_m / max(-point.z, 1.0e-3));
}
