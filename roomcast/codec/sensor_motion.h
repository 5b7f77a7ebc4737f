// SPDX-License-Identifier: Apache-2.0
// Detects that a depth sensor itself moves: all parts of its picture then change their distance
// within an eighth of a second, while people who move leave walls and corners unchanged. The
// picture is split into 4x4 regions. A region moves if the mean distance of a quarter of its 8x8
// blocks differs by more than noise from four frames ago. The decision changes slowly in both
// directions, so that a person who fills the view for a moment has no effect. Assumes about 30
// frames a second. Single-threaded.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::codec {

class SensorMotion {
 public:
  /// Takes the next frame, always of the same size. Returns whether the sensor moves.
  bool update(DepthView depth_mm);
  [[nodiscard]] bool moves() const { return moves_; }

 private:
  static constexpr std::size_t kFramesBack = 4;
  using Means = std::vector<float>;  // mm for each block, 0 = too few readings

  void measure(DepthView depth_mm);
  [[nodiscard]] double moving_share(const Means& before) const;
  void decide(double share);

  int blocks_wide_ = 0, blocks_high_ = 0;
  Means now_;
  std::array<Means, kFramesBack> before_;  // ring buffer
  std::size_t frame_ = 0;
  int frames_for_change_ = 0;  // consecutive frames that contradict `moves_`
  bool moves_ = false;
};

}  // namespace roomcast::codec
