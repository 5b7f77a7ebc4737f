// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/repeats.h"

#include <numbers>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/descriptor_products.h"

namespace roomcast::alignment {
namespace {

/// Adds a feature at (x, 0, 2) m with one filled bin.
void add_feature(FeatureSet& set, float x_m, std::size_t bin) {
  set.features.push_back({{x_m, 0, 2}, {0, 0}});
  set.descriptors.push_back({});
  set.descriptors.back()[bin] = kDescriptorLength;
}

TEST(Repeats, a_look_alike_elsewhere_makes_both_repeat) {
  FeatureSet set;
  add_feature(set, 0, 1);
  add_feature(set, 1, 2);
  add_feature(set, 2, 1);
  compute_ambiguity(set);
  EXPECT_EQ(set.features[0].nearest_similar_distance, 0);
  EXPECT_EQ(set.features[2].nearest_similar_distance, 0);
  EXPECT_TRUE(repeats(set.features[0]));
  // The second resembles nothing: its descriptor is perpendicular to the others.
  EXPECT_FLOAT_EQ(set.features[1].nearest_similar_distance, std::numbers::sqrt2_v<float>);
  EXPECT_FALSE(repeats(set.features[1]));
}

TEST(Repeats, a_feature_found_twice_in_one_place_is_no_repeat) {
  FeatureSet set;
  add_feature(set, 0, 1);
  add_feature(set, 0.11F, 1);  // 12 cm is elsewhere
  compute_ambiguity(set);
  EXPECT_FALSE(repeats(set.features[0]));
  set.features[1].point_m.x() = 0.13F;
  compute_ambiguity(set);
  EXPECT_TRUE(repeats(set.features[0]));
  EXPECT_TRUE(repeats(set.features[1]));
}

TEST(Repeats, look_alikes_are_found_beyond_one_tile) {
  // The look-alikes are the first and the last of more features than fit into a tile.
  FeatureSet set;
  add_feature(set, 0, 0);
  for (std::size_t i = 1; i <= kDescriptorTile; ++i)
    add_feature(set, static_cast<float>(i), 1 + i % (kDescriptorSize - 1));
  add_feature(set, -1, 0);
  compute_ambiguity(set);
  EXPECT_TRUE(repeats(set.features.front()));
  EXPECT_TRUE(repeats(set.features.back()));
  EXPECT_FALSE(repeats(set.features[1]));
  set.features.back().point_m = set.features.front().point_m;  // the same place, found twice
  compute_ambiguity(set);
  EXPECT_FALSE(repeats(set.features.front()));
  EXPECT_FALSE(repeats(set.features.back()));
}

TEST(Repeats, of_no_features_are_none) {
  FeatureSet empty;
  compute_ambiguity(empty);
  EXPECT_EQ(empty.size(), 0u);
}

TEST(Uniqueness, is_one_for_a_good_match_without_look_alikes) {
  EXPECT_EQ(uniqueness(0.3F, kNoSimilarFeature, kNoSimilarFeature), 1);
}

TEST(Uniqueness, is_least_where_either_feature_repeats) {
  for (const float look_alike : {0.F, 0.2F}) {
    EXPECT_FLOAT_EQ(uniqueness(0.01F, look_alike, kNoSimilarFeature), 0.05F);
    EXPECT_FLOAT_EQ(uniqueness(0.01F, kNoSimilarFeature, look_alike), 0.05F);
  }
}

TEST(Uniqueness, falls_as_the_match_comes_as_far_as_the_look_alike) {
  // Between 0.75 and 1.15 of the distance to the look-alike, from 1 to the least.
  EXPECT_FLOAT_EQ(uniqueness(0.75F, 1, 1), 1);
  EXPECT_NEAR(uniqueness(0.95F, 1, 1), 0.5F, 1e-5F);
  EXPECT_FLOAT_EQ(uniqueness(1.15F, 1, 1), 0.05F);
  // Look-alikes between 0.3 and 0.55 away make even an exact match doubtful.
  EXPECT_NEAR(uniqueness(0, 0.425F, 1), 0.5F, 1e-5F);
}

}  // namespace
}  // namespace roomcast::alignment
