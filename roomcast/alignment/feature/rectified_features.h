// SPDX-License-Identifier: Apache-2.0
// Plane-rectified SIFT (viewpoint-invariant patches, Wu et al. 2008): every large plane is rendered
// as seen face-on at a fixed metric scale, and SIFT is sought there. Such features match across
// viewing angles where those of the picture do not, and have a size in metres. Thread-safe (no
// state).
#pragma once

#include <span>

#include "roomcast/alignment/feature/feature_set.h"
#include "roomcast/alignment/view/color_picture.h"
#include "roomcast/alignment/view/planes.h"

namespace roomcast::alignment {

[[nodiscard]] FeatureSet rectified_features(const ColorPicture& picture,
                                            const DepthSurface& surface,
                                            std::span<const Plane> planes);

}  // namespace roomcast::alignment
