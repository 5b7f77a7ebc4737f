// SPDX-License-Identifier: Apache-2.0
// Tells whether a depth sensor itself moves: then all parts of its picture change their distance
// within an eighth of a second, where people who move leave walls and corners as they were. The
// picture is cut into 4x4 regions; a region moves when in a quarter of its 8x8 blocks the mean
// distance differs by more than noise from that of four frames ago. Slow to begin and slow to end,
// so that a person who fills the view for a moment changes nothing. Frames are thought to come at
// about 30 a second. Single-threaded.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::codec {

class SensorMotion {
 public:
  /// The next frame, always of the same size. Whether the sensor moves.
  bool update(DepthView depth_mm);
  [[nodiscard]] bool moves() const { return moves_; }

 private:
  static constexpr std::size_t kFramesBack = 4;
  using Means = std::vector<float>;  // millimetres for each block, 0 = too few readings

  void measure(DepthView depth_mm);
  [[nodiscard]] double moving_share(const Means& before) const;
  void decide(double share);

  int blocks_wide_ = 0, blocks_high_ = 0;
  Means now_;
  std::array<Means, kFramesBack> before_;  // a ring
  std::size_t frame_ = 0;
  int frames_for_change_ = 0;  // in a row that spoke against `moves_`
  bool moves_ = false;
};

}  // namespace roomcast::codec
