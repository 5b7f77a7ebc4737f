// SPDX-License-Identifier: Apache-2.0
// Detects that a depth sensor itself moves: all parts of its picture then change their distance
// within an eighth of a second by more than its noise, while people who move leave walls and
// corners unchanged. The noise is learnt (NoiseLaw): it differs from frame to frame but does not
// grow over four frames, as motion does. The picture is split into 4x4 regions. A region moves if
// the mean distance of half of its 8x8 blocks differs from four frames ago, or if that of the
// others differs a little, in one direction. The decision changes slowly in both directions, so
// that a person who fills the view for a moment has no effect. The times hold at 30 frames a
// second; at a few a second people change more from frame to frame, and still not half of most
// regions. Single-threaded.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "roomcast/codec/noise_law.h"
#include "roomcast/core/image.h"

namespace roomcast::codec {

class SensorMotion {
 public:
  /// Takes the next frame, always of the same size. Returns whether the sensor moves.
  bool update(DepthView depth_mm);
  [[nodiscard]] bool moves() const { return moves_; }
  [[nodiscard]] const NoiseLaw& noise() const { return noise_; }

 private:
  static constexpr std::size_t kFramesBack = 4, kKept = kFramesBack + 1;
  using Means = std::vector<float>;  // mm for each block, 0 = too few readings

  void measure(DepthView depth_mm);
  [[nodiscard]] const Means& means(std::size_t frames_ago) const {
    return means_[(frame_ + kKept - frames_ago) % kKept];
  }
  /// Of a block's mean, in standard deviations of its change by noise.
  [[nodiscard]] float change(float now_mm, float before_mm) const;
  [[nodiscard]] double moving_share() const;
  void decide(double share);

  int blocks_wide_ = 0, blocks_high_ = 0;
  std::array<Means, kKept> means_;  // ring buffer
  std::size_t frame_ = 0;
  NoiseLaw noise_;
  int frames_for_change_ = 0;  // consecutive frames that contradict `moves_`
  bool moves_ = false;
};

}  // namespace roomcast::codec
