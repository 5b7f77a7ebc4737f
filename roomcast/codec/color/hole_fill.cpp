// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/hole_fill.h"

#include <algorithm>

namespace roomcast::codec {
namespace {

/// Means over the known of each 2x2 pixels. Returns true if every coarse pixel is known.
bool push(ImageView<const std::uint8_t> value, MaskView known, ImageView<std::uint8_t> coarse_value,
          ImageView<std::uint8_t> coarse_known) {
  bool complete = true;
  for (int y = 0; y < coarse_value.height; ++y) {
    for (int x = 0; x < coarse_value.width; ++x) {
      int sum = 0, count = 0;
      for (int fine_y = 2 * y; fine_y < std::min(2 * y + 2, value.height); ++fine_y) {
        for (int fine_x = 2 * x; fine_x < std::min(2 * x + 2, value.width); ++fine_x) {
          if (!known.at(fine_x, fine_y)) continue;
          sum += value.at(fine_x, fine_y);
          ++count;
        }
      }
      coarse_known.at(x, y) = count > 0;
      coarse_value.at(x, y) = static_cast<std::uint8_t>(count ? (sum + count / 2) / count : 0);
      complete &= count > 0;
    }
  }
  return complete;
}

/// Bilinear: 9, 3, 3 and 1 sixteenths of the four nearest coarse pixels.
void pull(ImageView<const std::uint8_t> coarse, ImageView<std::uint8_t> value, MaskView known) {
  for (int y = 0; y < value.height; ++y) {
    const int near_y = y / 2, far_y = std::clamp(near_y + (y % 2 ? 1 : -1), 0, coarse.height - 1);
    for (int x = 0; x < value.width; ++x) {
      if (known.at(x, y)) continue;
      const int near_x = x / 2, far_x = std::clamp(near_x + (x % 2 ? 1 : -1), 0, coarse.width - 1);
      value.at(x, y) =
          static_cast<std::uint8_t>((9 * coarse.at(near_x, near_y) + 3 * coarse.at(far_x, near_y) +
                                     3 * coarse.at(near_x, far_y) + coarse.at(far_x, far_y) + 8) /
                                    16);
    }
  }
}

}  // namespace

void HoleFill::fill(ImageView<std::uint8_t> plane, MaskView known) {
  std::size_t depth = 0;
  ImageView<const std::uint8_t> value = plane;
  MaskView value_known = known;
  for (bool complete = false; !complete && (value.width > 1 || value.height > 1); ++depth) {
    if (levels_.size() == depth) levels_.emplace_back();
    Level& level = levels_[depth];
    level.value.resize((value.width + 1) / 2, (value.height + 1) / 2);
    level.known.resize(level.value.width(), level.value.height());
    complete = push(value, value_known, level.value.view(), level.known.view());
    value = level.value;
    value_known = level.known;
  }
  if (depth == 0 || !levels_[depth - 1].known.at(0, 0)) return;
  for (std::size_t i = depth - 1; i-- > 0;) {
    pull(levels_[i + 1].value, levels_[i].value.view(), levels_[i].known);
  }
  pull(levels_[0].value, plane, known);
}

}  // namespace roomcast::codec
