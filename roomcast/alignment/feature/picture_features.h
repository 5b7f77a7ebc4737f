// SPDX-License-Identifier: Apache-2.0
// SIFT features of the colour picture, lifted into space by the depth seen there. Those without
// depth, or at a depth edge, are dropped. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/feature/feature_set.h"
#include "roomcast/alignment/feature/sift_detector.h"
#include "roomcast/alignment/view/color_picture.h"
#include "roomcast/alignment/view/lift.h"

namespace roomcast::alignment {

[[nodiscard]] FeatureSet picture_features(const ColorPicture& picture, const DepthSurface& surface,
                                          const SiftOptions& sift = {},
                                          const LiftOptions& lifting = {});

}  // namespace roomcast::alignment
