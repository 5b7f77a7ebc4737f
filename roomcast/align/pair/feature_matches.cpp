// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/pair/feature_matches.h"

#include <cmath>
#include <span>

#include "roomcast/align/feature/descriptor_matching.h"
#include "roomcast/align/feature/repeats.h"

namespace roomcast::align {
namespace {

constexpr float kLargestDescriptorDistance = 0.75F;
constexpr float kLargestSizeOctaves = 0.6F;  // between sizes in metres of the same thing

using Repeating = std::vector<Descriptor>;

std::vector<const Repeating*> all_but(const std::vector<Repeating>& sets, std::size_t index) {
  std::vector<const Repeating*> others;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (i != index) others.push_back(&sets[i]);
  }
  return others;
}

bool sizes_agree(const Feature& a, const Feature& b) {
  if (a.size_m == 0 || b.size_m == 0) return true;
  return std::abs(std::log2(a.size_m / b.size_m)) < kLargestSizeOctaves;
}

void add_matches(const FeatureSet& a, std::span<const float> alike_a, const FeatureSet& b,
                 std::span<const float> alike_b, std::vector<PointMatch>& matches) {
  for (const DescriptorMatch& match :
       match_descriptors(a.descriptors, b.descriptors, kLargestDescriptorDistance)) {
    const Feature& in_a = a.features[match.a];
    const Feature& in_b = b.features[match.b];
    if (!sizes_agree(in_a, in_b)) continue;
    matches.push_back({in_a.point_m, in_b.point_m, in_a.pixel, in_b.pixel,
                       uniqueness(match.distance, alike_a[match.a], alike_b[match.b])});
  }
}

}  // namespace

std::vector<LookAlikes> look_alikes_of_rig(const std::vector<const SensorView*>& views) {
  std::vector<Repeating> in_pictures, on_planes;
  for (const SensorView* view : views) {
    in_pictures.push_back(repeating_descriptors(view->picture_features));
    on_planes.push_back(repeating_descriptors(view->rectified_features));
  }
  std::vector<LookAlikes> look_alikes;
  for (std::size_t i = 0; i < views.size(); ++i) {
    look_alikes.push_back(
        {look_alikes_in_rig(views[i]->picture_features, all_but(in_pictures, i)),
         look_alikes_in_rig(views[i]->rectified_features, all_but(on_planes, i))});
  }
  return look_alikes;
}

std::vector<PointMatch> match_features(const SensorView& a, const LookAlikes& alike_a,
                                       const SensorView& b, const LookAlikes& alike_b) {
  std::vector<PointMatch> matches;
  add_matches(a.picture_features, alike_a.of_picture_features, b.picture_features,
              alike_b.of_picture_features, matches);
  add_matches(a.rectified_features, alike_a.of_rectified_features, b.rectified_features,
              alike_b.of_rectified_features, matches);
  return matches;
}

}  // namespace roomcast::align
