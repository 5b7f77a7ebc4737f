// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/noise_law.h"

#include <algorithm>
#include <cmath>

namespace roomcast::codec {
namespace {

constexpr float kPriorSigma_mm = 0.7f;  // at 1 m; twice that of the Kinects and Xtions seen so far
constexpr float kMinBlockSigma_mm = 0.25f, kMaxPriors = 4;  // times the prior
constexpr int kMinBlocks = 24;  // of a distance, in a frame; fewer say nothing
// Largest change of the logarithm of sigma in a frame: the first frames may change it quickly.
constexpr float kQuickStep = 0.5f, kStep = 0.06f;
constexpr int kQuickFrames = 12;
// Median of |a - 2 b + c| for three means with Gaussian noise, in their standard deviations.
constexpr float kMedianOfSecondDifference = 0.6745f * 2.4495f;

float prior_mm(int knot) {
  const float z_m = static_cast<float>(sigma_knot_mm(knot)) / 1000;
  return std::max(kMinBlockSigma_mm, kPriorSigma_mm * z_m * z_m);
}

}  // namespace

NoiseLaw::NoiseLaw() {
  for (int knot = 0; knot < kSigmaKnotCount; ++knot) {
    sigma_mm_[static_cast<std::size_t>(knot)] = prior_mm(knot);
  }
}

// Moves each distance's estimate towards the median, by the share of blocks above and below it.
void NoiseLaw::learn(const ThreeFrames& blocks) {
  struct Count {
    int blocks = 0, above = 0;
  };
  std::array<Count, kSigmaKnotCount> counts;
  for (std::size_t i = 0; i < blocks.now_mm.size(); ++i) {
    const float now = blocks.now_mm[i], before = blocks.before_mm[i];
    const float long_before = blocks.long_before_mm[i];
    if (now == 0 || before == 0 || long_before == 0) continue;
    const auto knot = static_cast<std::size_t>(sigma_knot_of(static_cast<int>(before)));
    ++counts[knot].blocks;
    counts[knot].above +=
        std::abs(now - 2 * before + long_before) > kMedianOfSecondDifference * sigma_mm_[knot];
  }
  const float step = frames_ < kQuickFrames ? kQuickStep : kStep;
  frames_ = std::min(frames_ + 1, kQuickFrames);
  for (std::size_t knot = 0; knot < counts.size(); ++knot) {
    const Count& count = counts[knot];
    if (count.blocks < kMinBlocks) continue;
    const float excess = 2 * static_cast<float>(count.above) / static_cast<float>(count.blocks) - 1;
    sigma_mm_[knot] = std::clamp(sigma_mm_[knot] * std::exp(step * excess), kMinBlockSigma_mm,
                                 kMaxPriors * prior_mm(static_cast<int>(knot)));
  }
}

}  // namespace roomcast::codec
