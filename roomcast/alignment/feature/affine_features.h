// SPDX-License-Identifier: Apache-2.0
// Affine SIFT (Morel & Yu 2009): features of simulated oblique views of the picture, in every
// direction, lifted into space. They match across larger viewing angles than features of the
// picture itself, also where there is no plane to rectify. They take about ten times as long, so
// they are used only for sensors that cannot be placed otherwise. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/feature/feature_set.h"
#include "roomcast/alignment/feature/repeats.h"
#include "roomcast/alignment/feature/sift_detector.h"
#include "roomcast/alignment/view/color_picture.h"
#include "roomcast/alignment/view/lift.h"

namespace roomcast::alignment {

/// Chosen on the kitchen recording (ADR 11).
struct AffineFeatureOptions {
  SiftOptions sift{.max_features = 800, .min_contrast = 0.015, .largest_edge_ratio = 15};
  int max_tilt = kUsualMaxTilt;  // steps of a factor sqrt(2): 3 are a view from 70 degrees aside

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("sift", sift);
    visit("max_tilt", max_tilt, Range{0, 6});
  }
  [[nodiscard]] Status check() const { return check_fields("AffineFeatureOptions", *this); }
};

/// Features with `nearest_similar_distance` set (repeats.h). One place usually has several
/// features.
[[nodiscard]] FeatureSet affine_features(const ColorPicture& picture, const DepthSurface& surface,
                                         const AffineFeatureOptions& options = {},
                                         const LiftOptions& lifting = {},
                                         const RepeatOptions& repeating = {});

}  // namespace roomcast::alignment
