// SPDX-License-Identifier: Apache-2.0
// Estimates how a depth sensor's noise depends on distance, from its own frames: the deviation of
// the changes from frame to frame, trimmed to exclude moving objects, combined with the sensor's
// quantisation step. Where too few changes are known, e.g. in the first frame, the deviation of
// readings from the line between their neighbours is used. Older frames count less and less.
// Millimetres. docs/spec/codec.md §2.4.1.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "roomcast/codec/live/depth_domain.h"
#include "roomcast/core/image.h"

namespace roomcast::codec {

class SensorNoise {
 public:
  /// Adds a frame; call for every frame, in order.
  void observe(DepthView depth_mm);

  /// The current estimate for all distances; usable from the first frame on.
  [[nodiscard]] SigmaCodes table() const;

 private:
  static constexpr int kMaxChange_mm = 512;
  static constexpr int kRowsApart = 8;  // distance of the rows that are read in each frame
  using Histogram = std::array<std::uint32_t, kMaxChange_mm>;

  void observe_row(const std::uint16_t* row, const std::uint16_t* before, int width);
  void forget_half();
  [[nodiscard]] double sigma_at(int knot) const;
  [[nodiscard]] double step_at(int knot) const;

  std::array<Histogram, kSigmaKnotCount> in_time_{}, in_space_{};
  std::array<std::uint32_t, kSigmaKnotCount> time_samples_{}, space_samples_{};
  std::vector<std::uint32_t> readings_at_mm_;  // of each distance
  std::vector<std::uint16_t> before_;          // the previous frame, only the rows that are read
  int width_ = 0, height_ = 0, phase_ = 0, frames_ = 0;
};

}  // namespace roomcast::codec
