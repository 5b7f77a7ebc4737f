// SPDX-License-Identifier: Apache-2.0
// Candidate matches between two sensors' features, each weighted by its uniqueness within the rig.
// Features are compared once per pair. The weights depend on the features that repeat in any view
// of the rig, so they are computed after all pairs have been compared. Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/alignment/feature/feature_comparison.h"
#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/rigid_fit.h"

namespace roomcast::alignment {

struct MatchingOptions {
  float max_descriptor_distance = 0.75F;  // 0..2; loose, because votes sort out wrong matches.
                                          // Chosen on the development rooms (alignment_options.h)
  float max_size_octaves = 0.6F;          // between metric sizes of one feature; the prototype's

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_descriptor_distance", max_descriptor_distance, Range{0, 2});
    visit("max_size_octaves", max_size_octaves, Range{0, 10});
  }
  [[nodiscard]] Status check() const { return check_fields("MatchingOptions", *this); }
};

struct ViewComparison {
  FeatureComparison in_pictures, on_planes;

  /// Frees the matches after weighting: only the distances to repeats are needed then, to weight
  /// the matches of other pairs.
  void free_matches() { in_pictures.matches = on_planes.matches = {}; }
};

[[nodiscard]] ViewComparison compare_views(const SensorView& a, const SensorView& b,
                                           const MatchingOptions& options = {});

/// For every feature of a view: the descriptor distance to its nearest look-alike
/// (feature/repeats.h).
struct DescriptorAmbiguity {
  std::vector<float> of_picture_features, of_rectified_features;
};

/// Look-alikes within the view itself.
[[nodiscard]] DescriptorAmbiguity own_ambiguity(const SensorView& view);

/// Lowers the distances of features that resemble a repeating feature of the other view.
void add_repeats_of_b(const ViewComparison& comparison, DescriptorAmbiguity& of_a);
void add_repeats_of_a(const ViewComparison& comparison, DescriptorAmbiguity& of_b);

[[nodiscard]] std::vector<PointMatch> weighted_matches(const SensorView& a,
                                                       const DescriptorAmbiguity& of_a,
                                                       const SensorView& b,
                                                       const DescriptorAmbiguity& of_b,
                                                       const ViewComparison& comparison,
                                                       const MatchingOptions& options = {});

/// Matches of affine features, whose `nearest_similar_distance` must be set. Repeats in third views
/// are ignored because affine features are so many.
[[nodiscard]] std::vector<PointMatch> affine_matches(const FeatureSet& a, const FeatureSet& b,
                                                     const MatchingOptions& options = {},
                                                     const RepeatOptions& repeating = {});

}  // namespace roomcast::alignment
