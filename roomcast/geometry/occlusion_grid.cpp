// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/occlusion_grid.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "roomcast/core/assert.h"

namespace roomcast {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr std::int32_t kNowhere = 0;  // the corner of the border: no picture position maps to it

int cells_for(int pixels, int cell_size) {
  return (pixels + cell_size - 1) / cell_size;
}

}  // namespace

OcclusionGrid::OcclusionGrid(int picture_width, int picture_height, int cell_size)
    : columns_(cells_for(picture_width + 1, cell_size) + 2),
      rows_(cells_for(picture_height + 1, cell_size) + 2),

      cells_per_pixel_(1.0F / static_cast<float>(cell_size)) {
  ROOMCAST_ASSERT(picture_width >= 1 && picture_height >= 1 && cell_size >= 1);
  const std::size_t count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  splatted_m_.assign(count, kNothing);
  across_m_.assign(count, kNothing);
  nearest_m_.assign(count, kNothing);
}

void OcclusionGrid::clear() {
  std::fill(splatted_m_.begin(), splatted_m_.end(), kNothing);
}

void OcclusionGrid::find_cells(const float* __restrict u, const float* __restrict v,
                               const float* __restrict z_m, int count,
                               std::int32_t* __restrict cells) const {
  const float scale = cells_per_pixel_;
  // The border cell, the half pixel before the first pixel centre, and a small margin so that -0.5
  // never rounds into the border.
  const float first = 1.0F + 0.5F * scale + 1e-4F;
  const std::int32_t stride = columns_;
  for (int i = 0; i < count; ++i) {
    const std::int32_t x = static_cast<std::int32_t>(u[i] * scale + first);
    const std::int32_t y = static_cast<std::int32_t>(v[i] * scale + first);
    cells[i] = z_m[i] > 0 ? y * stride + x : kNowhere;
  }
}

void OcclusionGrid::splat_row(const float* u, const float* v, const float* z_m, int count,
                              std::int32_t* cells) {
  find_cells(u, v, z_m, count, cells);
  for (int i = 0; i < count; ++i) {
    float& nearest = splatted_m_[static_cast<std::size_t>(cells[i])];
    nearest = std::min(nearest, z_m[i]);
  }
}

void OcclusionGrid::finish() {
  splatted_m_[kNowhere] = kNothing;  // pixels without depth wrote their zeros there
  for (int y = 0; y < rows_; ++y) {
    const float* const in = splatted_m_.data() + index(0, y);
    float* const __restrict out = across_m_.data() + index(0, y);
    for (int x = 1; x < columns_ - 1; ++x) {
      out[x] = std::min(in[x], std::min(in[x - 1], in[x + 1]));
    }
  }
  for (int y = 1; y < rows_ - 1; ++y) {
    const float* const above = across_m_.data() + index(0, y - 1);
    const float* const here = across_m_.data() + index(0, y);
    const float* const below = across_m_.data() + index(0, y + 1);
    float* const __restrict out = nearest_m_.data() + index(0, y);
    for (int x = 1; x < columns_ - 1; ++x) {
      out[x] = std::min(here[x], std::min(above[x], below[x]));
    }
  }
  nearest_m_[kNowhere] = -kNothing;
}

}  // namespace roomcast
