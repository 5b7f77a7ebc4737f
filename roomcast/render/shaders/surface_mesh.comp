// Meshes the depth grid: two triangles per cell, fewer at breaks of the surface. Each cell has its own six indices, so
// the result does not depend on the order of execution.

layout(local_size_x = 16, local_size_y = 8) in;
layout(std430, binding = 0) writeonly buffer Indices { uint indices[]; };

layout(location = 4) uniform int grid_step;
layout(location = 5) uniform ivec2 cells;
layout(location = 6) uniform vec2 max_gap;  // metres, and share of the nearest corner's distance

const float kApart = 1.0e9;

// Depth difference of two neighbours; kApart if one is missing.
float gap(float a, float b) { return a > 0.0 && b > 0.0 ? abs(a - b) : kApart; }

bool connected(float a, float b, float c) {
  float nearest = min(a, min(b, c));
  return nearest > 0.0 && max(a, max(b, c)) - nearest < max_gap.x + max_gap.y * nearest;
}

uint index_of(ivec2 pixel) { return uint(pixel.y * grid_width() + pixel.x); }

void put(uint slot, bool whole, ivec2 a, ivec2 b, ivec2 c) {
  uint first = index_of(a);  // a dropped triangle repeats one vertex: no area
  indices[slot + 0u] = first;
  indices[slot + 1u] = whole ? index_of(b) : first;
  indices[slot + 2u] = whole ? index_of(c) : first;
}

void main() {
  ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(cell, cells))) return;
  ivec2 p00 = cell * grid_step;
  ivec2 p10 = p00 + ivec2(grid_step, 0);
  ivec2 p01 = p00 + ivec2(0, grid_step);
  ivec2 p11 = p00 + ivec2(grid_step);
  float z00 = z_at(p00), z10 = z_at(p10), z01 = z_at(p01), z11 = z_at(p11);

  // Cuts along the diagonal with the smaller depth difference: it follows an edge instead of crossing it, and a cell
  // with one missing corner keeps one triangle. Counter-clockwise as seen from the sensor.
  uint slot = 6u * uint(cell.y * cells.x + cell.x);
  if (gap(z10, z01) <= gap(z00, z11)) {
    put(slot, connected(z00, z01, z10), p00, p01, p10);
    put(slot + 3u, connected(z10, z01, z11), p10, p01, p11);
  } else {
    put(slot, connected(z00, z01, z11), p00, p01, p11);
    put(slot + 3u, connected(z00, z11, z10), p00, p11, p10);
  }
}
