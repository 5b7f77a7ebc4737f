// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/moving_outline.h"

#include <algorithm>

#include "roomcast/simulator/people/moving_picture.h"
#include "roomcast/simulator/sensing/depth_reading.h"

namespace roomcast::simulator {
namespace {

constexpr int kFineTile = 8;  // pixels

PixelBox grown(const PixelBox& box, int width, int height) {
  if (box.empty()) return {};
  return {std::max(0, box.left - 1), std::max(0, box.top - 1), std::min(width, box.right + 1),
          std::min(height, box.bottom + 1)};
}

}  // namespace

MovingOutline::MovingOutline(int width, int height)
    : sees_(width, height), rows_(3), fine_tiles_(2 * width, 2 * height, kFineTile) {}

void MovingOutline::gather_row(const MovingLayer& layer, const Image<float>& plate_z_m, int y,
                               std::vector<Range>& row) const {
  row.assign(static_cast<std::size_t>(box_.right - box_.left), {0.0F, 0.0F});
  if (y < layer.box().top || y >= layer.box().bottom) return;
  const auto moving_z = [&](int x) {
    const bool in_box = x >= layer.box().left && x < layer.box().right;
    return in_box && is_in_front(layer, plate_z_m, x, y) ? layer.z_m().at(x, y) : 0.0F;
  };
  float left = 0.0F, here = moving_z(box_.left);
  if (box_.left == 0) left = here;  // the picture's edge is not an outline
  for (int x = box_.left; x < box_.right; ++x) {
    const float right = x + 1 < plate_z_m.width() ? moving_z(x + 1) : here;
    row[static_cast<std::size_t>(x - box_.left)] = {std::min({left, here, right}),
                                                    std::max({left, here, right})};
    left = here;
    here = right;
  }
}

void MovingOutline::find(const MovingLayer& layer, const Image<float>& plate_z_m) {
  fine_tiles_.clear();
  box_ = grown(layer.box(), plate_z_m.width(), plate_z_m.height());
  if (box_.empty()) return;
  const int last = plate_z_m.height() - 1;
  const auto row = [&](int y) -> std::vector<Range>& {
    return rows_[static_cast<std::size_t>((y + 3) % 3)];
  };
  gather_row(layer, plate_z_m, std::max(0, box_.top - 1), row(box_.top - 1));
  gather_row(layer, plate_z_m, box_.top, row(box_.top));
  for (int y = box_.top; y < box_.bottom; ++y) {
    gather_row(layer, plate_z_m, std::min(last, y + 1), row(y + 1));
    for (int x = box_.left; x < box_.right; ++x) {
      const auto i = static_cast<std::size_t>(x - box_.left);
      const Range &above = row(y - 1)[i], &here = row(y)[i], &below = row(y + 1)[i];
      const float nearest = std::min({above.nearest, here.nearest, below.nearest});
      const float farthest = std::max({above.farthest, here.farthest, below.farthest});
      Sees& sees = sees_.at(x, y);
      sees = farthest == 0.0F                                      ? Sees::kStill
             : nearest > 0.0F && !is_depth_step(nearest, farthest) ? Sees::kMoving
                                                                   : Sees::kMaybeBoth;
      if (sees == Sees::kMaybeBoth) fine_tiles_.want(2 * x, 2 * y);
    }
  }
}

}  // namespace roomcast::simulator
