// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/feature/descriptor_matching.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/align/feature/descriptor_products.h"
#include "roomcast/align/feature/repeats.h"

namespace roomcast::align {
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

TEST(MatchDescriptors, finds_each_in_a_shuffled_copy) {
  const auto a = random_descriptors(60, 3);
  std::vector<Descriptor> b(a.rbegin(), a.rend());
  for (const DescriptorMatch& match : match_descriptors(a, b, 0.15F)) {
    EXPECT_EQ(match.b, a.size() - 1 - match.a);
  }
  EXPECT_EQ(match_descriptors(a, b, 0.15F).size(), a.size());
}

TEST(MatchDescriptors, keeps_several_partners_of_what_repeats) {
  const auto a = random_descriptors(1, 4);
  const std::vector<Descriptor> b(2, a[0]);
  const auto matches = match_descriptors(a, b, 0.1F);
  ASSERT_EQ(matches.size(), 2u);
  EXPECT_EQ(matches[0].b, 0u);
  EXPECT_EQ(matches[1].b, 1u);
}

TEST(MatchDescriptors, of_nothing_are_none) {
  const auto some = random_descriptors(5, 5);
  EXPECT_TRUE(match_descriptors({}, some, 2).empty());
  EXPECT_TRUE(match_descriptors(some, {}, 2).empty());
}

FeatureSet set_of(const std::vector<Descriptor>& descriptors, float apart_m) {
  FeatureSet set;
  for (std::size_t i = 0; i < descriptors.size(); ++i) {
    set.features.push_back({{apart_m * static_cast<float>(i), 0, 1}, {0, 0}});
  }
  set.descriptors = descriptors;
  return set;
}

TEST(Repeats, the_same_look_elsewhere_is_a_repeat_and_at_the_same_place_is_not) {
  auto descriptors = random_descriptors(3, 6);
  descriptors[2] = descriptors[0];
  FeatureSet far = set_of(descriptors, 1), near = set_of(descriptors, 0.01F);
  find_look_alikes(far);
  find_look_alikes(near);
  EXPECT_LT(far.features[0].look_alike, 0.1F);
  EXPECT_GT(far.features[1].look_alike, 0.5F);
  EXPECT_GT(near.features[0].look_alike, 0.5F);
  EXPECT_EQ(repeating_descriptors(far).size(), 2u);
}

TEST(Repeats, what_repeats_for_one_sensor_is_known_to_the_other) {
  const auto descriptors = random_descriptors(2, 7);
  FeatureSet twice = set_of({descriptors[0], descriptors[0], descriptors[1]}, 1);
  FeatureSet once = set_of(descriptors, 1);
  find_look_alikes(twice);
  find_look_alikes(once);
  const auto vocabulary = repeating_descriptors(twice);
  const std::vector<const std::vector<Descriptor>*> others = {&vocabulary};
  const auto alike = look_alikes_in_rig(once, others);
  EXPECT_LT(alike[0], 0.1F);
  EXPECT_GT(alike[1], 0.5F);
  EXPECT_GT(once.features[0].look_alike, 0.5F) << "its own view does not tell";
}

TEST(Repeats, a_match_is_worth_less_the_nearer_the_look_alike) {
  EXPECT_FLOAT_EQ(uniqueness(0.3F, 1.2F, 1.2F), 1);
  EXPECT_FLOAT_EQ(uniqueness(0.5F, 0.4F, 1.2F), 0.05F);
  EXPECT_GT(uniqueness(0.5F, 0.6F, 0.6F), uniqueness(0.55F, 0.6F, 0.6F));
}

}  // namespace
}  // namespace roomcast::align
