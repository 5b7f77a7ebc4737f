// SPDX-License-Identifier: Apache-2.0
// What two sensors may both see: matches of their features, each with what it is worth in this rig.
// Features are compared once per pair; what a match is worth depends on what repeats in any view of
// the rig, so it is found out when all pairs have been compared. Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/alignment/feature/feature_comparison.h"
#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/rigid_fit.h"

namespace roomcast::alignment {

struct ViewComparison {
  FeatureComparison in_pictures, on_planes;

  /// Once they are weighed only what repeats is of use, to weigh those of other pairs.
  void forget_matches() { in_pictures.matches = on_planes.matches = {}; }
};

[[nodiscard]] ViewComparison compare_views(const SensorView& a, const SensorView& b);

/// For every feature of a view the distance to its nearest look-alike (feature/repeats.h).
struct DescriptorAmbiguity {
  std::vector<float> of_picture_features, of_rectified_features;
};

/// Within the view itself.
[[nodiscard]] DescriptorAmbiguity own_look_alikes(const SensorView& view);

/// What a comparison with another view adds: what repeats there is known to both.
void add_repeats_of_b(const ViewComparison& comparison, DescriptorAmbiguity& of_a);
void add_repeats_of_a(const ViewComparison& comparison, DescriptorAmbiguity& of_b);

[[nodiscard]] std::vector<PointMatch> weighed_matches(const SensorView& a,
                                                      const DescriptorAmbiguity& of_a,
                                                      const SensorView& b,
                                                      const DescriptorAmbiguity& of_b,
                                                      const ViewComparison& comparison);

/// Of features that have their look-alikes, of which there are so many that what repeats in other
/// views is left aside.
[[nodiscard]] std::vector<PointMatch> affine_matches(const FeatureSet& a, const FeatureSet& b);

}  // namespace roomcast::alignment
