// SPDX-License-Identifier: Apache-2.0
// Reprojection residuals of matched features, both ways: where one sensor's feature, lifted into
// space by its own depth, falls in the other's colour picture. Pixels. Thread-safe (no state).
#pragma once

#include <span>

#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/pair/patch_scores.h"
#include "roomcast/alignment/pair/rigid_fit.h"
#include "roomcast/alignment/view/color_picture.h"

namespace roomcast::alignment {

/// How much the places of matched features are believed.
struct FeatureTrust {
  double sigma_px;   // of each, along either axis
  double share = 1;  // 1 where each errs for itself; less where they err together
};

/// What the matches say; those further off than 25 pixels say nothing.
[[nodiscard]] PairEquations feature_equations(const ColorPicture& a, const ColorPicture& b,
                                              const PairState& state,
                                              std::span<const PointMatch> matches,
                                              const FeatureTrust& trust);

/// The terms of feature_equations, by patches.
void add_feature_scores(const ColorPicture& a, const ColorPicture& b, const PairState& state,
                        std::span<const PointMatch> matches, const FeatureTrust& trust,
                        PairScores& scores);

/// To within how many pixels the places of these matches are known: from the median residual,
/// within reason.
[[nodiscard]] double feature_sigma_px(const ColorPicture& a, const ColorPicture& b,
                                      const PairState& state, std::span<const PointMatch> matches);

/// Before anything is known about it: static sensors do better, hand-held ones do not.
inline constexpr double kUsualFeatureSigma_px = 2;

}  // namespace roomcast::alignment
