// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/pattern_holes.h"

#include <algorithm>

#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {
namespace {

constexpr float kPatch_px = 9.0F;
constexpr float kThreshold = 0.5F, kThresholdRange = 0.4F;  // shares of the window

/// Numbers of readings left of and above each pixel (a summed-area table).
class ReadingCounts {
 public:
  explicit ReadingCounts(DepthView depth_mm)
      : width_(depth_mm.width),
        height_(depth_mm.height),
        sums_(depth_mm.width + 1, depth_mm.height + 1) {
    for (int x = 0; x <= width_; ++x) sums_.at(x, 0) = 0;
    for (int y = 0; y < height_; ++y) {
      std::uint32_t row = 0;
      sums_.at(0, y + 1) = 0;
      for (int x = 0; x < width_; ++x) {
        row += depth_mm.at(x, y) != 0 ? 1 : 0;
        sums_.at(x + 1, y + 1) = sums_.at(x + 1, y) + row;
      }
    }
  }

  /// The share of readings in the window around a pixel.
  [[nodiscard]] float share_around(int x, int y) const {
    const int left = std::max(0, x - kPatternReach_px);
    const int right = std::min(width_, x + kPatternReach_px + 1);
    const int top = std::max(0, y - kPatternReach_px);
    const int bottom = std::min(height_, y + kPatternReach_px + 1);
    const std::uint32_t count = sums_.at(right, bottom) - sums_.at(left, bottom) -
                                sums_.at(right, top) + sums_.at(left, top);
    return static_cast<float>(count) / static_cast<float>((right - left) * (bottom - top));
  }

 private:
  int width_, height_;
  Image<std::uint32_t> sums_;
};

/// The nearest reading of the row, to the left first; 0: none in the window.
std::uint16_t neighbour_mm(DepthView depth_mm, int x, int y) {
  for (int step = 1; step <= kPatternReach_px; ++step) {
    for (const int at : {x - step, x + step}) {
      if (at >= 0 && at < depth_mm.width && depth_mm.at(at, y) != 0) return depth_mm.at(at, y);
    }
  }
  return 0;
}

}  // namespace

void match_by_patches(std::uint32_t key, ImageView<std::uint16_t> depth_mm) {
  DepthImage before(depth_mm.width, depth_mm.height);
  for (int y = 0; y < depth_mm.height; ++y)
    std::copy_n(depth_mm.row(y), depth_mm.width, before.view().row(y));
  const ReadingCounts counts(before.view());
  for (int y = 0; y < depth_mm.height; ++y) {
    for (int x = 0; x < depth_mm.width; ++x) {
      const Eigen::Vector2f at(static_cast<float>(x) / kPatch_px,
                               static_cast<float>(y) / kPatch_px);
      const float share = counts.share_around(x, y);
      const bool matched =
          share >= 1.0F || share > kThreshold + kThresholdRange * value_noise(at, key);
      std::uint16_t& reading = depth_mm.at(x, y);
      if (!matched)
        reading = 0;
      else if (reading == 0)
        reading = neighbour_mm(before.view(), x, y);
    }
  }
}

}  // namespace roomcast::simulator
