// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/measure/truth_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace roomcast::bench {
namespace {

constexpr double kMoving_mm_per_s = 60;
constexpr double kSlowWindow_s = 0.5;
constexpr int kOtherSurface_mm = 20;
constexpr std::uint16_t kLongStill = 65535;

}  // namespace

TruthMotion::TruthMotion(double fps)
    : moving_step_mm_(std::max(1, static_cast<int>(std::lround(kMoving_mm_per_s / fps)))),
      slow_frames_(static_cast<std::uint16_t>(std::lround(kSlowWindow_s * fps))) {}

void TruthMotion::add(DepthView truth_mm) {
  const bool first = previous_mm_.empty();
  if (first) {
    previous_mm_.resize(truth_mm.width, truth_mm.height);
    frames_still_.resize(truth_mm.width, truth_mm.height, kLongStill);
    motion_.resize(truth_mm.width, truth_mm.height, Motion::kStatic);
  }
  for (int y = 0; y < truth_mm.height; ++y) {
    for (int x = 0; x < truth_mm.width; ++x) {
      const std::uint16_t now = truth_mm.at(x, y);
      const int change_mm = std::abs(now - previous_mm_.at(x, y));
      previous_mm_.at(x, y) = now;
      if (!first) motion_.at(x, y) = step(change_mm, frames_still_.at(x, y));
    }
  }
}

Motion TruthMotion::step(int change_mm, std::uint16_t& frames_still) const {
  if (change_mm > kOtherSurface_mm) {
    frames_still = kLongStill;
  } else if (change_mm > 0) {
    frames_still = 0;
  } else if (frames_still != kLongStill) {
    ++frames_still;
  }
  if (change_mm >= moving_step_mm_) return Motion::kMoving;
  return frames_still < slow_frames_ ? Motion::kSlow : Motion::kStatic;
}

}  // namespace roomcast::bench
