// SPDX-License-Identifier: Apache-2.0
// Affine SIFT (Morel & Yu 2009): features of simulated oblique views of the picture, in every
// direction, lifted into space. They match across larger viewing angles than features of the
// picture itself, also where there is no plane to rectify. They take about ten times as long, so
// they are used only for sensors that cannot be placed otherwise. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/feature/feature_set.h"
#include "roomcast/alignment/view/color_picture.h"

namespace roomcast::alignment {

/// Features with `nearest_similar_distance` set (repeats.h). One place usually has several
/// features.
[[nodiscard]] FeatureSet affine_features(const ColorPicture& picture, const DepthSurface& surface);

}  // namespace roomcast::alignment
