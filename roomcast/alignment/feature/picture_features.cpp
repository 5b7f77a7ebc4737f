// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/picture_features.h"

namespace roomcast::alignment {

FeatureSet picture_features(const ColorPicture& picture, const DepthSurface& surface,
                            const SiftOptions& sift, const LiftOptions& lifting) {
  FeatureSet set;
  for (const SiftFeature& found : detect_sift(picture.grey, {}, sift)) {
    const auto point_m = lift(picture, surface, found.pixel, lifting);
    if (!point_m) continue;
    set.features.push_back({*point_m, found.pixel});
    set.descriptors.push_back(found.descriptor);
  }
  return set;
}

}  // namespace roomcast::alignment
