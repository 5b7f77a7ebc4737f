// SPDX-License-Identifier: Apache-2.0
// How a depth sensor's noise grows with distance, measured from its own frames:
// the trimmed mean of what readings change from one frame to the next, so that
// moving things do not count, together with the steps that the sensor quantises
// distances to. Before there are two frames, how neighbours scatter around the
// line between them. What was seen seconds ago counts less and less. Millimetres.
// docs/spec/codec.md, "Domain".
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "roomcast/codec/live/depth_domain.h"
#include "roomcast/core/image.h"

namespace roomcast::codec {

class SensorNoise {
 public:
  /// Every frame once, in order.
  void observe(DepthView depth_mm);

  /// What is known now, for any distance; sane from the first frame on.
  [[nodiscard]] SigmaCodes table() const;

 private:
  static constexpr int kMaxChange_mm = 512;
  static constexpr int kRowsApart = 8;  // that each frame looks at
  using Histogram = std::array<std::uint32_t, kMaxChange_mm>;

  void observe_row(const std::uint16_t* row, const std::uint16_t* before, int width);
  void forget_half();
  [[nodiscard]] double sigma_at(int knot) const;
  [[nodiscard]] double step_at(int knot) const;

  std::array<Histogram, kSigmaKnotCount> in_time_{}, in_space_{};
  std::array<std::uint32_t, kSigmaKnotCount> time_samples_{}, space_samples_{};
  std::vector<std::uint8_t> seen_mm_;  // which distances occur at all
  std::vector<std::uint16_t> before_;  // the frame before, rows that are looked at
  int width_ = 0, height_ = 0, phase_ = 0, frames_ = 0;
};

}  // namespace roomcast::codec
