// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/picture_features.h"

#include "roomcast/alignment/feature/sift_detector.h"
#include "roomcast/alignment/view/lift.h"

namespace roomcast::alignment {

FeatureSet picture_features(const ColorPicture& picture, const DepthSurface& surface) {
  FeatureSet set;
  for (const SiftFeature& found : detect_sift(picture.grey, {}, SiftOptions{})) {
    const auto point_m = lift(picture, surface, found.pixel);
    if (!point_m) continue;
    set.features.push_back({*point_m, found.pixel});
    set.descriptors.push_back(found.descriptor);
  }
  return set;
}

}  // namespace roomcast::alignment
