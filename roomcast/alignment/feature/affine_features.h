// SPDX-License-Identifier: Apache-2.0
// Affine SIFT (Morel & Yu 2009): features of the picture as it would look from aside, in every
// direction, lifted into space. They match across larger angles than those of the picture itself,
// also where there is no plane to rectify, and take about ten times as long, so they are for
// sensors that cannot be placed otherwise. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/feature/feature_set.h"
#include "roomcast/alignment/view/color_picture.h"

namespace roomcast::alignment {

/// With their look-alikes (repeats.h). One place is usually among them several times.
[[nodiscard]] FeatureSet affine_features(const ColorPicture& picture, const DepthSurface& surface);

}  // namespace roomcast::alignment
