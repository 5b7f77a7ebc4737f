// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/sensor_motion.h"

#include <cmath>
#include <utility>

namespace roomcast::codec {
namespace {

constexpr int kSide = 8;          // of a block, pixels
constexpr int kPixelStep = 2;     // every second pixel is read, in both directions
constexpr int kMinReadings = 12;  // of 16
constexpr int kRegions = 4;       // in a row, and in a column
constexpr float kMinChange_mm = 6, kMinChangeShare = 0.004f;  // of the distance
constexpr double kMovingBlocks = 0.25;                        // share of a region's known blocks
constexpr double kMinKnown = 0.125;  // share of a region's blocks; a region with fewer is ignored
constexpr double kBegins = 0.6, kEnds = 0.4;  // share of the known regions
constexpr int kFramesToBegin = 3, kFramesToEnd = 12;

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

/// Numbers of a region's blocks with readings in both frames, and of those that moved.
struct Count {
  int known = 0, moved = 0;
  void add(float now_mm, float before_mm) {
    if (now_mm == 0 || before_mm == 0) return;
    ++known;
    moved += std::abs(now_mm - before_mm) > kMinChange_mm + kMinChangeShare * now_mm;
  }
};

}  // namespace

bool SensorMotion::update(DepthView depth_mm) {
  blocks_wide_ = depth_mm.width / kSide;
  blocks_high_ = depth_mm.height / kSide;
  measure(depth_mm);
  Means& before = before_[frame_++ % kFramesBack];
  if (!before.empty()) decide(moving_share(before));
  std::swap(before, now_);
  return moves_;
}

void SensorMotion::measure(DepthView depth_mm) {
  now_.resize(static_cast<std::size_t>(blocks_wide_) * static_cast<std::size_t>(blocks_high_));
  auto mean = now_.begin();
  for (int y = 0; y < blocks_high_; ++y) {
    for (int x = 0; x < blocks_wide_; ++x) *mean++ = mean_of_block(depth_mm, x * kSide, y * kSide);
  }
}

double SensorMotion::moving_share(const Means& before) const {
  std::array<Count, kRegions * kRegions> regions;
  for (int y = 0; y < blocks_high_; ++y) {
    for (int x = 0; x < blocks_wide_; ++x) {
      const auto block = static_cast<std::size_t>(y * blocks_wide_ + x);
      const int region = y * kRegions / blocks_high_ * kRegions + x * kRegions / blocks_wide_;
      regions[static_cast<std::size_t>(region)].add(now_[block], before[block]);
    }
  }
  const double least = kMinKnown * static_cast<double>(now_.size()) / regions.size();
  int known = 0, moving = 0;
  for (const Count& region : regions) {
    if (region.known == 0 || region.known < least) continue;
    ++known;
    moving += region.moved >= kMovingBlocks * region.known;
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
