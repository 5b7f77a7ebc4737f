// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/feature_comparison.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/descriptor_products.h"
#include "roomcast/alignment/feature/repeats.h"

namespace roomcast::alignment {
namespace {

Descriptor random_descriptor(std::mt19937& random) {
  std::array<float, kDescriptorSize> histogram;
  for (float& bin : histogram) bin = static_cast<float>(random() % 100 < 30 ? random() % 1000 : 0);
  return root_descriptor(histogram);
}

std::vector<Descriptor> random_descriptors(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Descriptor> descriptors;
  for (std::size_t i = 0; i < count; ++i) descriptors.push_back(random_descriptor(random));
  return descriptors;
}

TEST(RootDescriptor, has_the_agreed_length) {
  std::mt19937 random(1);
  const Descriptor descriptor = random_descriptor(random);
  std::int32_t squared = 0;
  for (const std::int16_t value : descriptor) squared += value * value;
  EXPECT_NEAR(descriptor_distance(squared), 0, 0.05);
}

TEST(RootDescriptor, of_an_empty_histogram_is_zero) {
  EXPECT_EQ(root_descriptor(std::array<float, kDescriptorSize>{}), Descriptor{});
}

TEST(DescriptorProducts, equal_those_of_the_plain_version) {
  const auto descriptors = random_descriptors(37, 2);
  std::vector<std::int32_t> fast(descriptors.size()), plain(descriptors.size());
  for (const Descriptor& descriptor : descriptors) {
    descriptor_products(descriptor, descriptors, fast);
    descriptor_products_reference(descriptor, descriptors, plain);
    EXPECT_EQ(fast, plain);
  }
}

FeatureSet set_of(const std::vector<Descriptor>& descriptors, float apart_m) {
  FeatureSet set;
  for (std::size_t i = 0; i < descriptors.size(); ++i) {
    set.features.push_back({{apart_m * static_cast<float>(i), 0, 1}, {0, 0}});
  }
  set.descriptors = descriptors;
  return set;
}

std::vector<DescriptorMatch> matches_of(const std::vector<Descriptor>& a,
                                        const std::vector<Descriptor>& b, float largest_distance) {
  return compare_features(set_of(a, 1), set_of(b, 1), largest_distance).matches;
}

TEST(CompareFeatures, finds_each_in_a_shuffled_copy) {
  const auto a = random_descriptors(60, 3);
  const auto matches = matches_of(a, {a.rbegin(), a.rend()}, 0.15F);
  for (const DescriptorMatch& match : matches) EXPECT_EQ(match.b, a.size() - 1 - match.a);
  EXPECT_EQ(matches.size(), a.size());
}

TEST(CompareFeatures, finds_those_beyond_the_first_tile) {
  const auto many = random_descriptors(2100, 8);
  const auto matches = matches_of({many[2050]}, many, 0.15F);
  ASSERT_EQ(matches.size(), 1u);
  EXPECT_EQ(matches[0].b, 2050u);
}

TEST(CompareFeatures, keeps_several_partners_of_what_repeats) {
  const auto a = random_descriptors(1, 4);
  const auto matches = matches_of(a, {a[0], a[0]}, 0.1F);
  ASSERT_EQ(matches.size(), 2u);
  EXPECT_EQ(matches[0].b, 0u);
  EXPECT_EQ(matches[1].b, 1u);
}

TEST(CompareFeatures, of_nothing_are_none) {
  const auto some = random_descriptors(5, 5);
  EXPECT_TRUE(matches_of({}, some, 2).empty());
  EXPECT_TRUE(matches_of(some, {}, 2).empty());
}

TEST(Repeats, the_same_look_elsewhere_is_a_repeat_and_at_the_same_place_is_not) {
  auto descriptors = random_descriptors(3, 6);
  descriptors[2] = descriptors[0];
  FeatureSet far = set_of(descriptors, 1), near = set_of(descriptors, 0.01F);
  compute_ambiguity(far);
  compute_ambiguity(near);
  EXPECT_LT(far.features[0].nearest_similar_distance, 0.1F);
  EXPECT_GT(far.features[1].nearest_similar_distance, 0.5F);
  EXPECT_GT(near.features[0].nearest_similar_distance, 0.5F);
  EXPECT_TRUE(repeats(far.features[0]));
  EXPECT_TRUE(repeats(far.features[2]));
  EXPECT_FALSE(repeats(near.features[0]));
}

TEST(Repeats, what_repeats_for_one_sensor_is_known_to_the_other) {
  const auto descriptors = random_descriptors(2, 7);
  FeatureSet twice = set_of({descriptors[0], descriptors[0], descriptors[1]}, 1);
  FeatureSet once = set_of(descriptors, 1);
  compute_ambiguity(twice);
  compute_ambiguity(once);
  const FeatureComparison one_way = compare_features(once, twice, 0.1F);
  const FeatureComparison other_way = compare_features(twice, once, 0.1F);
  for (const auto& alike : {one_way.a_to_repeat, other_way.b_to_repeat}) {
    EXPECT_LT(alike[0], 0.1F);
    EXPECT_GT(alike[1], 0.5F);
  }
  EXPECT_GT(once.features[0].nearest_similar_distance, 0.5F) << "its own view does not tell";
}

TEST(Repeats, a_match_is_worth_less_the_nearer_the_look_alike) {
  EXPECT_FLOAT_EQ(uniqueness(0.3F, 1.2F, 1.2F), 1);
  EXPECT_FLOAT_EQ(uniqueness(0.5F, 0.4F, 1.2F), 0.05F);
  EXPECT_GT(uniqueness(0.5F, 0.6F, 0.6F), uniqueness(0.55F, 0.6F, 0.6F));
}

}  // namespace
}  // namespace roomcast::alignment
