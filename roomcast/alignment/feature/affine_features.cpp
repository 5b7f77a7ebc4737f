// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/affine_features.h"

#include "roomcast/alignment/feature/repeats.h"
#include "roomcast/alignment/feature/sift_detector.h"
#include "roomcast/alignment/view/lift.h"

namespace roomcast::alignment {
namespace {

constexpr SiftOptions kOfEachTilt{800, 0.015, 15};

}  // namespace

FeatureSet affine_features(const ColorPicture& picture, const DepthSurface& surface) {
  FeatureSet set;
  for (const SiftFeature& found : detect_affine_sift(picture.grey, kOfEachTilt)) {
    const auto point_m = lift(picture, surface, found.pixel);
    if (!point_m) continue;
    set.features.push_back({*point_m, found.pixel});
    set.descriptors.push_back(found.descriptor);
  }
  compute_ambiguity(set);
  return set;
}

}  // namespace roomcast::alignment
