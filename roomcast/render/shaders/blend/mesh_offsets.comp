// Computes the position of each tile's triangles in the whole mesh, and the draw commands with the total count.

layout(local_size_x = 256) in;
struct Command { uint count, instances, first, base, first_instance; };

layout(std430, binding = 1) readonly buffer Counts { uint tile_counts[]; };
layout(std430, binding = 2) writeonly buffer Offsets { uint tile_offsets[]; };
layout(std430, binding = 3) writeonly buffer Commands { Command commands[2]; };  // one for one eye, one for two

layout(location = 0) uniform uint tiles;

shared uint sums[256];

void main() {
  uint me = gl_LocalInvocationIndex;
  uint each = (tiles + 255u) / 256u;
  uint begin = min(me * each, tiles), end = min(begin + each, tiles);
  uint mine = 0u;
  for (uint i = begin; i < end; ++i) mine += tile_counts[i];
  sums[me] = mine;
  barrier();
  for (uint reach = 1u; reach < 256u; reach *= 2u) {
    uint more = me >= reach ? sums[me - reach] : 0u;
    barrier();
    sums[me] += more;
    barrier();
  }
  uint offset = sums[me] - mine;
  for (uint i = begin; i < end; ++i) {
    tile_offsets[i] = offset;
    offset += tile_counts[i];
  }
  if (me < 2u) commands[me] = Command(sums[255], me + 1u, 0u, 0u, 0u);
}
