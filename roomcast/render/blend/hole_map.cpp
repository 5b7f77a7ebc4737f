// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/hole_map.h"

namespace roomcast::render {

void HoleMap::find(std::span<const float> depth, int width) {
  const auto columns = static_cast<std::size_t>(width);
  const std::size_t rows = depth.size() / columns;
  stride_ = columns + 1;
  before_.assign(stride_ * (rows + 1), 0);
  for (std::size_t y = 0; y < rows; ++y) {
    const float* const row = &depth[y * columns];
    const std::uint32_t* const above = &before_[y * stride_ + 1];
    std::uint32_t* const here = &before_[(y + 1) * stride_ + 1];
    std::uint32_t in_row = 0;
    for (std::size_t x = 0; x < columns; ++x) {
      in_row += row[x] >= 1 ? 1 : 0;
      here[x] = above[x] + in_row;
    }
  }
}

}  // namespace roomcast::render
