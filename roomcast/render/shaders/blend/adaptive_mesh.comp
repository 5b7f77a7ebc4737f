// Meshes one tile of 16x16 cells of the depth grid with a quadtree. A node becomes two triangles if the surface in it
// is flat to within its noise (a plane is linear in inverse depth). Cells outside flat nodes are cut along the diagonal
// with the smaller depth difference; triangles across a break are dropped. Each tile writes to its own range, each cell
// in the order of its number, so the same surface always gives the same triangles.

layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = 0) writeonly buffer Tiles { uint tile_indices[]; };  // kMaxIndices per tile
layout(std430, binding = 1) writeonly buffer Counts { uint tile_counts[]; };
layout(binding = 5) uniform sampler2D covering_depth_m;
layout(binding = 6) uniform sampler2D velocities;  // metres per second

layout(location = 4) uniform vec2 max_gap;     // metres, and share of the nearest corner's distance
layout(location = 5) uniform bool is_covered;  // parts on the covering surface are not drawn
// Only what lies wholly before that surface is drawn, and, where the surface is unknown, what moves.
layout(location = 6) uniform bool needs_covering;

const int kSide = 16;
const int kSamples = kSide + 1;
const int kMaxIndices = 6 * kSide * kSide;
const int kLevels = 4;  // nodes of 2, 4, 8 and 16 cells
const int kFirstNode[4] = int[4](0, 64, 80, 84);
const int kNodes = 85;
const float kApart = 1.0e9;
const float kMoves = 0.25;  // m/s; slower could be noise

shared float z[kSamples * kSamples];
shared bool hidden[kSamples * kSamples];  // by the covering surface
shared uint is_bent[kNodes];
shared uint is_shown[kNodes];  // at least one sample is not hidden
shared uint before[kSide * kSide];

int sample_at(ivec2 p) { return p.y * kSamples + p.x; }

int node_at(int level, ivec2 cell) {
  int across = kSide >> (level + 1);
  ivec2 node = cell >> (level + 1);
  return kFirstNode[level] + node.y * across + node.x;
}

bool moves(ivec2 pixel) { return length(texelFetch(velocities, pixel, 0).xyz) > kMoves; }

bool is_hidden_at(ivec2 pixel, float here) {
  if (!is_covered || here == 0.0) return false;
  float covering = texelFetch(covering_depth_m, pixel, 0).r;
  if (covering == 0.0) return needs_covering && !moves(pixel);
  return abs(covering - here) < same_surface_gate(here);
}

void load_samples(ivec2 first) {
  ivec2 size = textureSize(depth_m, 0);
  for (int i = int(gl_LocalInvocationIndex); i < kSamples * kSamples; i += kSide * kSide) {
    ivec2 pixel = first + ivec2(i % kSamples, i / kSamples);
    bool inside = all(lessThan(pixel, size));
    z[i] = inside ? z_at(pixel) : 0.0;
    hidden[i] = inside && is_hidden_at(pixel, z[i]);
  }
  for (int i = int(gl_LocalInvocationIndex); i < kNodes; i += kSide * kSide) {
    is_bent[i] = 0u;
    is_shown[i] = 0u;
  }
}

// True if a sample is on the plane through its node's corners, to within the noise.
bool lies_in_node(ivec2 p, ivec2 first, int side) {
  float z00 = z[sample_at(first)], z10 = z[sample_at(first + ivec2(side, 0))];
  float z01 = z[sample_at(first + ivec2(0, side))], z11 = z[sample_at(first + side)];
  float here = z[sample_at(p)];
  if (min(min(z00, z10), min(z01, z11)) == 0.0 || here == 0.0) return false;
  vec2 at = vec2(p - first) / float(side);
  float inverse = mix(mix(1.0 / z00, 1.0 / z10, at.x), mix(1.0 / z01, 1.0 / z11, at.x), at.y);
  return abs(1.0 / inverse - here) < 1.2 * depth_sigma(here) + 0.0012;
}

void judge(ivec2 p, int level) {
  int side = 2 << level;
  for (int i = 0; i < 4; ++i) {  // a sample on a border belongs to all nodes there
    ivec2 cell = p - ivec2(i & 1, i >> 1);
    bool same_as_before = ((i & 1) != 0 && p.x % side != 0) || ((i >> 1) != 0 && p.y % side != 0);
    if (same_as_before || any(lessThan(cell, ivec2(0))) || any(greaterThanEqual(cell, ivec2(kSide)))) continue;
    int node = node_at(level, cell);
    bool is_part = lies_in_node(p, (cell / side) * side, side) && !(needs_covering && hidden[sample_at(p)]);
    if (!is_part) atomicOr(is_bent[node], 1u);
    if (!hidden[sample_at(p)]) atomicOr(is_shown[node], 1u);
  }
}

float gap(float a, float b) { return a > 0.0 && b > 0.0 ? abs(a - b) : kApart; }

bool connected(float a, float b, float c) {
  float nearest = min(a, min(b, c));
  return nearest > 0.0 && max(a, max(b, c)) - nearest < max_gap.x + max_gap.y * nearest;
}

void main() {
  ivec2 first = kSide * ivec2(gl_WorkGroupID.xy);
  load_samples(first);
  barrier();
  for (int i = int(gl_LocalInvocationIndex); i < kSamples * kSamples; i += kSide * kSide) {
    for (int level = 0; level < kLevels; ++level) judge(ivec2(i % kSamples, i / kSamples), level);
  }
  barrier();

  // The largest flat node around the cell is drawn by the node's first cell.
  ivec2 cell = ivec2(gl_LocalInvocationID.xy);
  int side = 1;
  bool shown = false;
  for (int level = kLevels - 1; level >= 0 && side == 1; --level) {
    int node = node_at(level, cell);
    if (is_bent[node] != 0u) continue;
    side = 2 << level;
    shown = is_shown[node] != 0u && all(equal(cell % side, ivec2(0)));
  }
  ivec2 p00 = cell, p10 = cell + ivec2(side, 0), p01 = cell + ivec2(0, side), p11 = cell + side;
  bool upper = shown, lower = shown, along_falling = true;
  if (side == 1) {
    float z00 = z[sample_at(p00)], z10 = z[sample_at(p10)], z01 = z[sample_at(p01)], z11 = z[sample_at(p11)];
    bvec4 corners = bvec4(hidden[sample_at(p00)], hidden[sample_at(p10)], hidden[sample_at(p01)], hidden[sample_at(p11)]);
    bool is_hidden = needs_covering ? any(corners) : all(corners);
    along_falling = gap(z10, z01) <= gap(z00, z11);
    upper = !is_hidden && (along_falling ? connected(z00, z01, z10) : connected(z00, z01, z11));
    lower = !is_hidden && (along_falling ? connected(z10, z01, z11) : connected(z00, z11, z10));
  }

  // A prefix sum gives the position of this cell's triangles, after those of all cells before it.
  uint me = gl_LocalInvocationIndex;
  uint mine = (upper ? 3u : 0u) + (lower ? 3u : 0u);
  before[me] = mine;
  barrier();
  for (uint reach = 1u; reach < uint(kSide * kSide); reach *= 2u) {
    uint more = me >= reach ? before[me - reach] : 0u;
    barrier();
    before[me] += more;
    barrier();
  }
  uint tile = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  uint slot = tile * uint(kMaxIndices) + before[me] - mine;
  p00 += first, p10 += first, p01 += first, p11 += first;
  uvec4 corner = uvec4(index_of(p00), index_of(p10), index_of(p01), index_of(p11));
  if (upper) {
    tile_indices[slot] = corner.x;
    tile_indices[slot + 1u] = corner.z;
    tile_indices[slot + 2u] = along_falling ? corner.y : corner.w;
    slot += 3u;
  }
  if (lower) {
    tile_indices[slot] = along_falling ? corner.y : corner.x;
    tile_indices[slot + 1u] = along_falling ? corner.z : corner.w;
    tile_indices[slot + 2u] = along_falling ? corner.w : corner.y;
  }
  if (me == uint(kSide * kSide - 1)) tile_counts[tile] = before[me];
}
