// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/drift_detector.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "roomcast/core/vector_loop.h"

namespace roomcast::codec {
namespace {

constexpr int kPatchSide = 4;
constexpr int kMinSamples = 10;         // of 16 pixels
constexpr float kNewest = 0.3f;         // weight of the newest frame
constexpr float kNewestLately = 0.45f;  // the same for a block that moved lately
constexpr std::uint8_t kLately_frames = 4;
// In sigmas of a pixel's noise; enough where pixels share no noise.
constexpr float kMaxPatchOffset = 0.9f, kMaxBlockOffset = 0.3f;
// With shared noise: five standard deviations of the running average, whose noise is 0.37 times
// the mean change of an offset from frame to frame (Gaussian, kNewest).
constexpr float kOffsetPerChange = 5 * 0.37f;
constexpr float kMaxOffset = 3;  // more than that is a jump of pixels

// Mean changes where pixels share no noise: means of 16 and of 64 pixels.
constexpr float kPatchChange = 0.28f, kBlockChange = 0.14f;
constexpr float kMaxChange = 2;         // of a sample; larger ones are motion
constexpr float kNewestChange = 0.06f;  // weight of the newest frame; the first ones have more
constexpr float kPriorFrames = 4;       // what is expected counts as so many frames
// A few pixels' offset is noise where patches change more than that.
constexpr float kSharedPatchChange = 0.45f;
constexpr float kSqrt3 = 1.7320508f;
constexpr float kUnknownOffset = std::numeric_limits<float>::quiet_NaN();

struct Columns {
  std::int16_t* off;
  std::uint16_t* close;
  std::uint16_t* deviation;
};

float offset_limit(float least, float change) {
  return std::clamp(kOffsetPerChange * change, least, kMaxOffset);
}

ROOMCAST_VECTOR_CLONES
void add_row(const std::int16_t* off, const std::uint16_t* close, const std::uint16_t* deviation,
             int width, const Columns& columns) {
  std::int16_t* to_off = columns.off;
  std::uint16_t* to_close = columns.close;
  std::uint16_t* to_deviation = columns.deviation;
  ROOMCAST_INDEPENDENT_ITERATIONS
  for (int x = 0; x < width; ++x) {
    to_off[x] = static_cast<std::int16_t>(to_off[x] + off[x]);
    to_close[x] = static_cast<std::uint16_t>(to_close[x] + close[x]);
    to_deviation[x] = static_cast<std::uint16_t>(to_deviation[x] + deviation[x]);
  }
}

}  // namespace

void DriftDetector::resize(const BlockGrid& grid) {
  grid_ = grid;
  const auto padded = static_cast<std::size_t>(grid.wide * kBlockSide);
  column_off_.assign(padded, 0);
  column_close_.assign(padded, 0);
  column_deviation_.assign(padded, 0);
  offset_.assign(4 * grid.block_count(), 0);
  newest_.assign(4 * grid.block_count(), kUnknownOffset);
  before_ = long_before_ = newest_;
  patch_change_.assign(4 * grid.block_count(), kPatchChange);
  block_change_.assign(grid.block_count(), kBlockChange);
  frames_since_motion_.assign(grid.block_count(), kLately_frames);
}

void DriftDetector::update(const FrameChange& change, const PixelHistory& history) {
  for (std::uint8_t& frames : frames_since_motion_) {
    frames = std::min<std::uint8_t>(kLately_frames, frames + 1);
  }
  ++frames_;
  newest_weight_ = std::max(kNewestChange, 1 / (kPriorFrames + static_cast<float>(frames_)));
  std::swap(before_, long_before_);
  std::swap(newest_, before_);
  std::fill(newest_.begin(), newest_.end(), kUnknownOffset);
  for (int y = 0; y < grid_.height; y += kPatchSide) {
    add_up_rows(change, history, y);
    for (int x = 0; x < grid_.width; x += kPatchSide) update_patch(x / kPatchSide, y / kPatchSide);
  }
  for (std::size_t block = 0; block < grid_.block_count(); ++block) learn_noise(block);
}

void DriftDetector::add_up_rows(const FrameChange& change, const PixelHistory& history, int y) {
  std::fill(column_off_.begin(), column_off_.end(), std::int16_t{0});
  std::fill(column_close_.begin(), column_close_.end(), std::uint16_t{0});
  std::fill(column_deviation_.begin(), column_deviation_.end(), std::uint16_t{0});
  const Columns columns{column_off_.data(), column_close_.data(), column_deviation_.data()};
  for (int row = y; row < std::min(grid_.height, y + kPatchSide); ++row) {
    const std::size_t at = grid_.pixel(0, row);
    add_row(&change.off[at], &change.close[at], &history.deviation[at], grid_.width, columns);
  }
}

void DriftDetector::update_patch(int patch_x, int patch_y) {
  int off = 0, close = 0, deviation = 0;
  for (int x = patch_x * kPatchSide; x < (patch_x + 1) * kPatchSide; ++x) {
    const auto i = static_cast<std::size_t>(x);
    off += column_off_[i];
    close += column_close_[i];
    deviation += column_deviation_[i];
  }
  if (close < kMinSamples) return;
  const std::size_t block = grid_.block(patch_x / 2, patch_y / 2);
  const std::size_t patch = 4 * block + static_cast<std::size_t>(patch_x % 2 + 2 * (patch_y % 2));
  // The mean absolute value of Gaussian noise is 4/5 of its standard deviation.
  const float sigma = std::max(static_cast<float>(kLevelsPerSigma),
                               static_cast<float>(deviation) * (1.25f / (1 << kNoiseShift) / 16));
  newest_[patch] = static_cast<float>(off) / static_cast<float>(close) / sigma;
  offset_[patch] += (newest_[patch] - offset_[patch]) *
                    (frames_since_motion_[block] < kLately_frames ? kNewestLately : kNewest);
}

void DriftDetector::learn_noise(std::size_t block) {
  float sum = 0;
  for (std::size_t patch = 4 * block; patch < 4 * block + 4; ++patch) {
    // The second difference, which motion of constant speed leaves 0. It has the noise of
    // 1 + 4 + 1 offsets, a change that of two.
    const float change = (newest_[patch] - 2 * before_[patch] + long_before_[patch]) / kSqrt3;
    sum += change;
    if (std::isnan(change)) continue;
    patch_change_[patch] +=
        newest_weight_ * (std::min(std::abs(change), kMaxChange) - patch_change_[patch]);
  }
  if (std::isnan(sum)) return;
  float& of_block = block_change_[block];
  of_block += newest_weight_ * (std::min(std::abs(sum) / 4, kMaxChange) - of_block);
}

BlockDrift DriftDetector::of(std::size_t block) const {
  BlockDrift drift;
  float sum = 0;
  for (std::size_t patch = 4 * block; patch < 4 * block + 4; ++patch) {
    sum += offset_[patch];
    drift.drifts |= std::abs(offset_[patch]) > offset_limit(kMaxPatchOffset, patch_change_[patch]);
    drift.shares_noise |= patch_change_[patch] > kSharedPatchChange;
  }
  drift.drifts |= std::abs(sum) > 4 * offset_limit(kMaxBlockOffset, block_change_[block]);
  return drift;
}

void DriftDetector::reset(std::size_t block) {
  std::fill_n(offset_.begin() + static_cast<std::ptrdiff_t>(4 * block), 4, 0.0f);
  std::fill_n(newest_.begin() + static_cast<std::ptrdiff_t>(4 * block), 4, kUnknownOffset);
}

void DriftDetector::expect_motion(std::size_t block) {
  frames_since_motion_[block] = 0;
}

}  // namespace roomcast::codec
