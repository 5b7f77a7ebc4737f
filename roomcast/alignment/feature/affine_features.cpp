// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/affine_features.h"

namespace roomcast::alignment {
FeatureSet affine_features(const ColorPicture& picture, const DepthSurface& surface,
                           const AffineFeatureOptions& options, const LiftOptions& lifting,
                           const RepeatOptions& repeating) {
  FeatureSet set;
  for (const SiftFeature& found :
       detect_affine_sift(picture.grey, options.sift, options.max_tilt)) {
    const auto point_m = lift(picture, surface, found.pixel, lifting);
    if (!point_m) continue;
    set.features.push_back({*point_m, found.pixel});
    set.descriptors.push_back(found.descriptor);
  }
  compute_ambiguity(set, repeating);
  return set;
}

}  // namespace roomcast::alignment
