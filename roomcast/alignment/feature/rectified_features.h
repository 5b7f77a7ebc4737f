// SPDX-License-Identifier: Apache-2.0
// Plane-rectified SIFT (viewpoint-invariant patches, Wu et al. 2008): every large plane is rendered
// face-on at one metric scale, and SIFT features are detected there. They match across viewing
// angles at which features of the picture do not, and they have a size in metres. Thread-safe (no
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
