// SPDX-License-Identifier: Apache-2.0
// The static part of a series of depth pictures: the median over time of every pixel that has a
// reading in more than half of the pictures, and a mask of the unsteady pixels. Unsteadiness is
// measured by the median absolute deviation, not by the standard deviation, so a person who crosses
// the view for a few frames has no effect. Millimetres. Thread-safe (no state).
#pragma once

#include <span>

#include "roomcast/core/image.h"
#include "roomcast/core/option_fields.h"

namespace roomcast::alignment {

/// Chosen by hand, well above the noise of a static reading.
struct SteadyDepthOptions {
  /// Largest deviation (standard, estimated from the median one) of a steady reading: a constant,
  /// and a share of the depth.
  double max_sigma_mm = 20, max_sigma_per_depth = 0.01;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_sigma_mm", max_sigma_mm, Range{0, 1000});
    visit("max_sigma_per_depth", max_sigma_per_depth, Range{0, 1});
  }
  [[nodiscard]] Status check() const { return check_fields("SteadyDepthOptions", *this); }
};

struct SteadyDepth {
  DepthImage depth_mm;  // 0 where there is no steady reading
  MaskImage moving;     // 255 where the readings disagree
};

/// `pictures_mm`: at least one, all of one size.
[[nodiscard]] SteadyDepth steady_depth(std::span<const DepthImage> pictures_mm,
                                       const SteadyDepthOptions& options = {});

}  // namespace roomcast::alignment
