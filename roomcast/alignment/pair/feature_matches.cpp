// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/feature_matches.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace roomcast::alignment {
namespace {

std::vector<float> look_alikes(const FeatureSet& set) {
  std::vector<float> distances;
  for (const Feature& feature : set.features) distances.push_back(feature.nearest_similar_distance);
  return distances;
}

void lower(std::vector<float>& distances, std::span<const float> others) {
  for (std::size_t i = 0; i < distances.size(); ++i)
    distances[i] = std::min(distances[i], others[i]);
}

bool sizes_agree(const Feature& a, const Feature& b, float max_octaves) {
  if (a.size_m == 0 || b.size_m == 0) return true;
  return std::abs(std::log2(a.size_m / b.size_m)) < max_octaves;
}

void add_matches(const FeatureSet& a, std::span<const float> alike_a, const FeatureSet& b,
                 std::span<const float> alike_b, const FeatureComparison& comparison,
                 const MatchingOptions& options, const RepeatOptions& repeating,
                 std::vector<PointMatch>& matches) {
  for (const DescriptorMatch& match : comparison.matches) {
    const Feature& in_a = a.features[match.a];
    const Feature& in_b = b.features[match.b];
    if (!sizes_agree(in_a, in_b, options.max_size_octaves)) continue;
    matches.push_back({in_a.point_m, in_b.point_m, in_a.pixel, in_b.pixel,
                       uniqueness(match.distance, alike_a[match.a], alike_b[match.b], repeating)});
  }
}

}  // namespace

ViewComparison compare_views(const SensorView& a, const SensorView& b,
                             const MatchingOptions& options) {
  const float max_distance = options.max_descriptor_distance;
  const RepeatOptions& repeating = a.options.repeating;
  return {compare_features(a.picture_features, b.picture_features, max_distance, repeating),
          compare_features(a.rectified_features, b.rectified_features, max_distance, repeating)};
}

DescriptorAmbiguity own_ambiguity(const SensorView& view) {
  return {look_alikes(view.picture_features), look_alikes(view.rectified_features)};
}

void add_repeats_of_b(const ViewComparison& comparison, DescriptorAmbiguity& of_a) {
  lower(of_a.of_picture_features, comparison.in_pictures.a_to_repeat);
  lower(of_a.of_rectified_features, comparison.on_planes.a_to_repeat);
}

void add_repeats_of_a(const ViewComparison& comparison, DescriptorAmbiguity& of_b) {
  lower(of_b.of_picture_features, comparison.in_pictures.b_to_repeat);
  lower(of_b.of_rectified_features, comparison.on_planes.b_to_repeat);
}

std::vector<PointMatch> weighted_matches(const SensorView& a, const DescriptorAmbiguity& of_a,
                                         const SensorView& b, const DescriptorAmbiguity& of_b,
                                         const ViewComparison& comparison,
                                         const MatchingOptions& options) {
  std::vector<PointMatch> matches;
  add_matches(a.picture_features, of_a.of_picture_features, b.picture_features,
              of_b.of_picture_features, comparison.in_pictures, options, a.options.repeating,
              matches);
  add_matches(a.rectified_features, of_a.of_rectified_features, b.rectified_features,
              of_b.of_rectified_features, comparison.on_planes, options, a.options.repeating,
              matches);
  return matches;
}

std::vector<PointMatch> affine_matches(const FeatureSet& a, const FeatureSet& b,
                                       const MatchingOptions& options,
                                       const RepeatOptions& repeating) {
  const FeatureComparison comparison =
      compare_features(a, b, options.max_descriptor_distance, repeating);
  std::vector<float> alike_a = look_alikes(a), alike_b = look_alikes(b);
  lower(alike_a, comparison.a_to_repeat);
  lower(alike_b, comparison.b_to_repeat);
  std::vector<PointMatch> matches;
  add_matches(a, alike_a, b, alike_b, comparison, options, repeating, matches);
  return matches;
}

}  // namespace roomcast::alignment
