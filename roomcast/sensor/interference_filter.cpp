// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/interference_filter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace roomcast::sensor {
namespace {

using Shown = InterferenceMeter::Shown;

// Filtering begins above these figures, and ends below half of what exceeds none.
constexpr double kMinFlickering = 0.0045, kMinNoiseRatio = 1.5;
constexpr int kPart_px = 16;
constexpr float kUsualWeight = 1.0F / 32, kOfUsual = 2;
constexpr float kMaxMoving = 12;          // readings of a block and its neighbours that changed,
                                          // beyond kOfUsual times those that usually do
constexpr double kMaxMissingShare = 0.5;  // share of a block's still surface
constexpr int kTogether = 3;              // of eight neighbours that changed alike
constexpr float kBurst = 1.5F;            // noise ratio of a frame whose noise is reduced

bool is_moving(Shown shown) {
  return shown == Shown::kNearer || shown == Shown::kFarther;
}

}  // namespace

void InterferenceFilter::filter(DepthImage& depth_mm) {
  meter_.add(depth_mm);
  decide();
  if (!is_active_) return;
  count_blocks();
  before_ = depth_mm;
  // Most of a frame is still and without a burst of noise, and stays as it is.
  const bool is_burst = meter_.noise_ratio_now() >= kBurst;
  for (int y = 1; y < depth_mm.height() - 1; ++y) {
    const Shown* shown = meter_.shown().row(y);
    std::uint16_t* out_mm = depth_mm.view().row(y);
    for (int x = 1; x < depth_mm.width() - 1; ++x) {
      if (shown[x] == Shown::kUnknown || (shown[x] == Shown::kStill && !is_burst)) continue;
      out_mm[x] = filtered(before_, x, y);
    }
  }
}

void InterferenceFilter::decide() {
  const InterferenceFigures figures = meter_.figures();
  const double share = is_active_ ? 0.5 : 1;
  is_active_ = figures.is_known && (figures.flickering > share * kMinFlickering ||
                                    figures.noise_ratio - 1 > share * (kMinNoiseRatio - 1));
}

void InterferenceFilter::count_blocks() {
  const auto shown = meter_.shown();
  blocks_wide_ = (shown.width + kPart_px - 1) / kPart_px;
  blocks_high_ = (shown.height + kPart_px - 1) / kPart_px;
  blocks_.resize(static_cast<std::size_t>(blocks_wide_) * static_cast<std::size_t>(blocks_high_));
  for (Block& block : blocks_) {
    block.usual_moving += kUsualWeight * (static_cast<float>(block.moving) - block.usual_moving);
    block.moving = block.missing = block.still = 0;
  }
  for (int y = 0; y < shown.height; ++y) {
    Block* blocks = &blocks_[static_cast<std::size_t>(y / kPart_px * blocks_wide_)];
    for (int x = 0; x < shown.width; ++x) {
      Block& block = blocks[x / kPart_px];
      block.moving += is_moving(shown.at(x, y));
      block.missing += shown.at(x, y) == Shown::kMissing;
      block.still += shown.at(x, y) == Shown::kStill;
    }
  }
}

bool InterferenceFilter::may_hold(int x, int y) const {
  const int column = x / kPart_px, row = y / kPart_px;
  Block around;
  for (int j = std::max(0, row - 1); j <= std::min(blocks_high_ - 1, row + 1); ++j) {
    for (int i = std::max(0, column - 1); i <= std::min(blocks_wide_ - 1, column + 1); ++i) {
      const Block& block = blocks_[static_cast<std::size_t>(j * blocks_wide_ + i)];
      around.moving += block.moving;
      around.missing += block.missing;
      around.still += block.still;
      around.usual_moving += block.usual_moving;
    }
  }
  const Block& here = blocks_[static_cast<std::size_t>(row * blocks_wide_ + column)];
  const float most = kMaxMoving + kOfUsual * around.usual_moving;
  return static_cast<float>(around.moving) <= most &&
         here.missing <= kMaxMissingShare * (here.missing + here.still);
}

/// Whether neighbours have changed by about as much, in the same direction: something moves.
bool InterferenceFilter::changed_together(DepthView depth_mm, int x, int y) const {
  const Shown here = meter_.shown().at(x, y);
  const int reading = depth_mm.at(x, y);
  const float same_mm = meter_.same_mm(depth_mm.at(x, y));
  int alike = 0;
  for (int j = y - 1; j <= y + 1; ++j) {
    for (int i = x - 1; i <= x + 1; ++i) {
      if ((i == x && j == y) || meter_.shown().at(i, j) != here) continue;
      alike += static_cast<float>(std::abs(depth_mm.at(i, j) - reading)) < same_mm;
    }
  }
  return alike >= kTogether;
}

std::uint16_t InterferenceFilter::filtered(DepthView depth_mm, int x, int y) const {
  const std::uint16_t reading = depth_mm.at(x, y);
  const auto still_mm = static_cast<float>(meter_.still_16th_mm(x, y)) / 16;
  const auto rounded = [](float mm) { return static_cast<std::uint16_t>(std::lround(mm)); };
  switch (meter_.shown().at(x, y)) {
    case Shown::kMissing:
      return may_hold(x, y) ? rounded(still_mm) : reading;
    case Shown::kNearer:
    case Shown::kFarther:
      return changed_together(depth_mm, x, y) ? reading : rounded(still_mm);
    case Shown::kStill: {
      const float ratio = meter_.noise_ratio_now();
      return rounded(still_mm + (static_cast<float>(reading) - still_mm) / (ratio * ratio));
    }
    case Shown::kUnknown:
      break;
  }
  return reading;
}

}  // namespace roomcast::sensor
