// Concatenates the triangles of all tiles.

layout(local_size_x = 256) in;
layout(std430, binding = 0) readonly buffer Tiles { uint tile_indices[]; };
layout(std430, binding = 1) readonly buffer Counts { uint tile_counts[]; };
layout(std430, binding = 2) readonly buffer Offsets { uint tile_offsets[]; };
layout(std430, binding = 3) writeonly buffer Indices { uint indices[]; };

const uint kMaxIndices = 6u * 16u * 16u;

void main() {
  uint tile = gl_WorkGroupID.x;
  uint count = tile_counts[tile], to = tile_offsets[tile], from = tile * kMaxIndices;
  for (uint i = gl_LocalInvocationIndex; i < count; i += 256u) indices[to + i] = tile_indices[from + i];
}
