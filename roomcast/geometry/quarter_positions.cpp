// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/quarter_positions.h"

#include <algorithm>
#include <cmath>

namespace roomcast {
namespace {

// Neighbours further apart in depth are not on the same surface.
constexpr float kApart_m = 0.012F, kApartPer_m = 0.022F;
constexpr float kQuarter = 0.25F;

struct Step {
  float u, v;
};

bool same_surface(float a, float b) {
  return a > 0 && b > 0 && std::abs(a - b) < kApart_m + kApartPer_m * std::min(a, b);
}

/// Step in the colour picture from pixel to pixel around `at`; neighbours are `stride` elements
/// apart.
Step step_along(const ProjectedSurface& surface, std::size_t at, std::size_t stride,
                bool has_before, bool has_after, Step otherwise) {
  const float z = surface.z_m[at];
  const bool before = has_before && same_surface(surface.z_m[at - stride], z);
  const bool after = has_after && same_surface(surface.z_m[at + stride], z);
  if (!before && !after) return otherwise;
  const std::size_t from = before ? at - stride : at, to = after ? at + stride : at;
  const float share = before && after ? 0.5F : 1.0F;
  return {share * (surface.u[to] - surface.u[from]), share * (surface.v[to] - surface.v[from])};
}

}  // namespace

void find_quarters(const ProjectedSurface& surface, int y, QuarterRow& upper, QuarterRow& lower) {
  const auto width = static_cast<std::size_t>(surface.width);
  for (QuarterRow* row : {&upper, &lower}) {
    row->u.resize(2 * width);
    row->v.resize(2 * width);
  }
  for (std::size_t x = 0; x < width; ++x) {
    const std::size_t at = static_cast<std::size_t>(y) * width + x;
    const Step across = step_along(surface, at, 1, x > 0, x + 1 < width, {surface.spacing, 0});
    const Step down =
        step_along(surface, at, width, y > 0, y + 1 < surface.height, {0, surface.spacing});
    for (const int side : {-1, 1}) {
      const std::size_t i = 2 * x + (side > 0 ? 1 : 0);
      for (const int level : {-1, 1}) {
        const float right = kQuarter * static_cast<float>(side);
        const float below = kQuarter * static_cast<float>(level);
        QuarterRow& row = level < 0 ? upper : lower;
        const float u = surface.u[at] + right * across.u + below * down.u;
        const float v = surface.v[at] + right * across.v + below * down.v;
        row.u[i] = std::clamp(u, 0.0F, surface.largest_u);
        row.v[i] = std::clamp(v, 0.0F, surface.largest_v);
      }
    }
  }
}

}  // namespace roomcast
