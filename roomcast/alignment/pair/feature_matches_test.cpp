// SPDX-License-Identifier: Apache-2.0
// Features whose descriptors are given: bin i alone is filled, so any two are either equal
// (distance 0) or as different as can be (distance sqrt 2).
#include "roomcast/alignment/pair/feature_matches.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/wall_fixture.h"

namespace roomcast::alignment {
namespace {

Descriptor descriptor_with_bin(std::size_t bin) {
  Descriptor descriptor{};
  descriptor[bin] = kDescriptorLength;
  return descriptor;
}

/// Features with these bins, a metre apart in space, with `size_m`.
FeatureSet features_with_bins(const std::vector<std::size_t>& bins, float size_m = 0) {
  FeatureSet set;
  for (const std::size_t bin : bins) {
    const auto place = static_cast<float>(set.size());
    set.features.push_back({{place, 0, 2}, {10 * place, 20}, size_m});
    set.descriptors.push_back(descriptor_with_bin(bin));
  }
  return set;
}

/// A view with nothing but these features.
SensorView view_with(FeatureSet in_picture, FeatureSet on_planes = {}) {
  SensorView view = featureless_view("v", DepthImage(200, 160), ColorImage(400, 320));
  view.picture_features = std::move(in_picture);
  view.rectified_features = std::move(on_planes);
  return view;
}

std::vector<PointMatch> matches_between(const SensorView& a, const SensorView& b) {
  return weighted_matches(a, own_ambiguity(a), b, own_ambiguity(b), compare_views(a, b));
}

TEST(FeatureMatches, bring_equal_descriptors_together) {
  const SensorView a = view_with(features_with_bins({1, 2, 3}));
  const SensorView b = view_with(features_with_bins({9, 3, 1}));
  const auto matches = matches_between(a, b);
  ASSERT_EQ(matches.size(), 2u);
  EXPECT_EQ(matches[0].a_m, Eigen::Vector3f(0, 0, 2));
  EXPECT_EQ(matches[0].b_m, Eigen::Vector3f(2, 0, 2));
  EXPECT_EQ(matches[0].a_pixel, Eigen::Vector2f(0, 20));
  EXPECT_EQ(matches[0].b_pixel, Eigen::Vector2f(20, 20));
  EXPECT_EQ(matches[0].weight, 1);
  EXPECT_EQ(matches[1].a_m, Eigen::Vector3f(2, 0, 2));
  EXPECT_EQ(matches[1].b_m, Eigen::Vector3f(1, 0, 2));
}

TEST(FeatureMatches, features_of_pictures_and_of_planes_are_not_mixed) {
  const SensorView a = view_with(features_with_bins({1}), features_with_bins({2}));
  const SensorView b = view_with(features_with_bins({2}), features_with_bins({1}));
  EXPECT_TRUE(matches_between(a, b).empty());
  EXPECT_EQ(matches_between(a, a).size(), 2u);
}

TEST(FeatureMatches, of_other_sizes_are_left_out_where_sizes_are_known) {
  const auto matched = [](float size_a_m, float size_b_m) {
    return matches_between(view_with({}, features_with_bins({1}, size_a_m)),
                           view_with({}, features_with_bins({1}, size_b_m)))
        .size();
  };
  EXPECT_EQ(matched(0.10F, 0.14F), 1u);  // half an octave
  EXPECT_EQ(matched(0.10F, 0.16F), 0u);  // 0.68 octaves
  EXPECT_EQ(matched(0.16F, 0.10F), 0u);
  EXPECT_EQ(matched(0, 0.16F), 1u);
}

TEST(FeatureMatches, weigh_nothing_where_a_feature_looks_like_another) {
  SensorView a = view_with(features_with_bins({1, 2}));
  const SensorView b = view_with(features_with_bins({1, 2}));
  a.picture_features.features[1].nearest_similar_distance = 0.1F;
  const auto matches = matches_between(a, b);
  ASSERT_EQ(matches.size(), 2u);
  EXPECT_EQ(matches[0].weight, 1);
  EXPECT_FLOAT_EQ(matches[1].weight, 0.05F);
}

TEST(FeatureMatches, a_repeat_in_one_view_is_one_in_every_view) {
  const SensorView a = view_with(features_with_bins({1, 2}));
  SensorView b = view_with(features_with_bins({1, 2}));
  b.picture_features.features[1].nearest_similar_distance = 0;  // repeats
  const ViewComparison comparison = compare_views(a, b);
  DescriptorAmbiguity of_a = own_ambiguity(a), of_b = own_ambiguity(b);
  EXPECT_EQ(of_a.of_picture_features, (std::vector<float>{kNoSimilarFeature, kNoSimilarFeature}));
  add_repeats_of_b(comparison, of_a);
  // a's second feature equals the repeat; its first has nothing in common with it.
  EXPECT_EQ(of_a.of_picture_features, (std::vector<float>{kNoSimilarFeature, 0}));
  add_repeats_of_a(comparison, of_b);  // a has no repeats of its own
  EXPECT_EQ(of_b.of_picture_features, (std::vector<float>{kNoSimilarFeature, 0}));
}

TEST(FeatureMatches, once_freed_only_the_distances_to_repeats_remain) {
  const SensorView a = view_with(features_with_bins({1}), features_with_bins({2}));
  ViewComparison comparison = compare_views(a, a);
  ASSERT_EQ(comparison.in_pictures.matches.size() + comparison.on_planes.matches.size(), 2u);
  comparison.free_matches();
  EXPECT_TRUE(comparison.in_pictures.matches.empty());
  EXPECT_TRUE(comparison.on_planes.matches.empty());
  EXPECT_EQ(comparison.in_pictures.a_to_repeat.size(), 1u);
}

TEST(AffineMatches, heed_the_repeats_of_both_sets) {
  const FeatureSet a = features_with_bins({1, 2});
  FeatureSet b = features_with_bins({1, 2, 2});
  b.features[2].nearest_similar_distance = 0;
  // a's second feature equals the repeat, so that its match to another is worth as little.
  for (const auto& matches : {affine_matches(a, b), affine_matches(b, a)}) {
    ASSERT_EQ(matches.size(), 3u);
    EXPECT_EQ(matches[0].weight, 1);
    EXPECT_FLOAT_EQ(matches[1].weight, 0.05F);
    EXPECT_FLOAT_EQ(matches[2].weight, 0.05F);
  }
  EXPECT_TRUE(affine_matches(a, {}).empty());
}

}  // namespace
}  // namespace roomcast::alignment
