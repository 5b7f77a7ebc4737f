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

/// Equations of the matches; residuals of 25 pixels or more are ignored.
[[nodiscard]] PairEquations feature_equations(const ColorPicture& a, const ColorPicture& b,
                                              const PairState& state,
                                              std::span<const PointMatch> matches,
                                              const FeatureTrust& trust);

/// Adds the terms of feature_equations to `scores`, per patch.
void add_feature_scores(const ColorPicture& a, const ColorPicture& b, const PairState& state,
                        std::span<const PointMatch> matches, const FeatureTrust& trust,
                        PairScores& scores);

/// Standard deviation of the positions of these matches, pixels, from the median residual; clamped
/// to 0.6..3.
[[nodiscard]] double feature_sigma_px(const ColorPicture& a, const ColorPicture& b,
                                      const PairState& state, std::span<const PointMatch> matches);

/// Value to use before it is estimated: static sensors do better, hand-held ones do not.
inline constexpr double kUsualFeatureSigma_px = 2;

}  // namespace roomcast::alignment
