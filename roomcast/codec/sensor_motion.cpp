// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/sensor_motion.h"

#include <algorithm>
#include <cmath>

namespace roomcast::codec {
namespace {

constexpr int kSide = 8;               // of a block, pixels
constexpr int kPixelStep = 2;          // every second pixel is read, in both directions
constexpr int kMinReadings = 12;       // of 16
constexpr int kRegions = 4;            // in a row, and in a column
constexpr float kMinNoise_mm = 4;      // of a change; a sensor with less shakes by as much
constexpr float kFarBeyondNoise = 2;   // in standard deviations of a change by noise
constexpr double kMovingBlocks = 0.5;  // share of a region's known blocks
constexpr double kCoherent = 0.25;     // mean change of the other blocks, in standard deviations
constexpr double kMinOthers = 0.3;     // share of the known blocks; fewer do not tell a mean change
constexpr double kMinKnown = 0.125;    // share of a region's blocks; a region with fewer is ignored
constexpr double kBegins = 0.55, kEnds = 0.4;  // share of the known regions
constexpr int kFramesToBegin = 3, kFramesToEnd = 11;

float mean_of_block(DepthView depth_mm, int x0, int y0) {
  int sum = 0, count = 0;
  for (int y = y0; y < y0 + kSide; y += kPixelStep) {
    const std::uint16_t* row = depth_mm.row(y);
    for (int x = x0; x < x0 + kSide; x += kPixelStep) {
      sum += row[x];
      count += row[x] != 0;
    }
  }
  return count < kMinReadings ? 0.0f : static_cast<float>(sum) / static_cast<float>(count);
}

/// The blocks of a region that have readings in both frames.
struct RegionChange {
  int known = 0, moved = 0;
  double sum = 0;  // of the changes of those that did not move, in standard deviations

  void add(float change) {
    ++known;
    if (std::abs(change) > kFarBeyondNoise)
      ++moved;
    else
      sum += change;
  }
  /// Either many blocks change by more than noise, or those that do not all change a little, in the
  /// same direction: noise averages out. People change their own blocks and leave the others.
  [[nodiscard]] bool moves() const {
    if (moved >= kMovingBlocks * known) return true;
    const int others = known - moved;
    return others >= kMinOthers * known && std::abs(sum) >= kCoherent * others;
  }
};

}  // namespace

bool SensorMotion::update(DepthView depth_mm) {
  blocks_wide_ = depth_mm.width / kSide;
  blocks_high_ = depth_mm.height / kSide;
  ++frame_;
  measure(depth_mm);
  if (!means(2).empty()) noise_.learn({means(0), means(1), means(2)});
  if (!means(kFramesBack).empty()) decide(moving_share());
  return moves_;
}

void SensorMotion::measure(DepthView depth_mm) {
  Means& now = means_[frame_ % kKept];
  now.resize(static_cast<std::size_t>(blocks_wide_) * static_cast<std::size_t>(blocks_high_));
  auto mean = now.begin();
  for (int y = 0; y < blocks_high_; ++y) {
    for (int x = 0; x < blocks_wide_; ++x) *mean++ = mean_of_block(depth_mm, x * kSide, y * kSide);
  }
}

float SensorMotion::change(float now_mm, float before_mm) const {
  const float noise_mm = std::sqrt(2.0f) * noise_.sigma_mm(before_mm);
  return (now_mm - before_mm) / std::max(kMinNoise_mm, noise_mm);
}

double SensorMotion::moving_share() const {
  const Means &now = means(0), &before = means(kFramesBack);
  std::array<RegionChange, kRegions * kRegions> regions;
  for (int y = 0; y < blocks_high_; ++y) {
    for (int x = 0; x < blocks_wide_; ++x) {
      const auto block = static_cast<std::size_t>(y * blocks_wide_ + x);
      if (now[block] == 0 || before[block] == 0) continue;
      const int region = y * kRegions / blocks_high_ * kRegions + x * kRegions / blocks_wide_;
      regions[static_cast<std::size_t>(region)].add(change(now[block], before[block]));
    }
  }
  const double least = kMinKnown * static_cast<double>(now.size()) / regions.size();
  int known = 0, moving = 0;
  for (const RegionChange& region : regions) {
    if (region.known == 0 || region.known < least) continue;
    ++known;
    moving += region.moves();
  }
  return known ? static_cast<double>(moving) / known : 0;
}

void SensorMotion::decide(double share) {
  const bool against = moves_ ? share < kEnds : share >= kBegins;
  frames_for_change_ = against ? frames_for_change_ + 1 : 0;
  if (frames_for_change_ < (moves_ ? kFramesToEnd : kFramesToBegin)) return;
  moves_ = !moves_;
  frames_for_change_ = 0;
}

}  // namespace roomcast::codec
