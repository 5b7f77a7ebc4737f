// SPDX-License-Identifier: Apache-2.0
// Reprojection residuals of matched features, both ways: one sensor's feature, lifted into space by
// its own depth, is projected into the other's colour picture. Pixels. Thread-safe (no state).
#pragma once

#include <span>

#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/pair/patch_scores.h"
#include "roomcast/alignment/pair/rigid_fit.h"
#include "roomcast/alignment/view/color_picture.h"

namespace roomcast::alignment {

/// Confidence in the positions of matched features.
struct FeatureTrust {
  double sigma_px;   // of each feature, along either axis
  double share = 1;  // 1 for independent errors; less for correlated errors
};

struct FeatureResidualOptions {
  double max_residual_px = 25;  // larger ones are ignored; beyond the 20 pixels of ADR 11
  double nearest_m = 0.2;       // along the axis; nearer points have no pixel
  /// Limits of the estimated standard deviation; by hand.
  double min_sigma_px = 0.6, max_sigma_px = 3;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_residual_px", max_residual_px, Range{1, 1000});
    visit("nearest_m", nearest_m, Range{0.01, 10});
    visit("min_sigma_px", min_sigma_px, Range{0.01, 100});
    visit("max_sigma_px", max_sigma_px, Range{0.01, 100});
  }
  [[nodiscard]] Status check() const {
    if (Status status = check_fields("FeatureResidualOptions", *this); !status) return status;
    return check_at_most("FeatureResidualOptions", "min_sigma_px", min_sigma_px, "max_sigma_px",
                         max_sigma_px);
  }
};

/// Equations of the matches; those with too large residuals are ignored.
[[nodiscard]] PairEquations feature_equations(const ColorPicture& a, const ColorPicture& b,
                                              const PairState& state,
                                              std::span<const PointMatch> matches,
                                              const FeatureTrust& trust,
                                              const FeatureResidualOptions& options = {});

/// Adds the terms of feature_equations to `scores`, per patch.
void add_feature_scores(const ColorPicture& a, const ColorPicture& b, const PairState& state,
                        std::span<const PointMatch> matches, const FeatureTrust& trust,
                        PairScores& scores, const FeatureResidualOptions& options = {});

/// Standard deviation of the positions of these matches, pixels, from the median residual,
/// within the limits.
[[nodiscard]] double feature_sigma_px(const ColorPicture& a, const ColorPicture& b,
                                      const PairState& state, std::span<const PointMatch> matches,
                                      const FeatureResidualOptions& options = {});

/// Value to use before it is estimated: static sensors do better, hand-held ones do not.
inline constexpr double kUsualFeatureSigma_px = 2;

}  // namespace roomcast::alignment
