// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/feature_set.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

using Histogram = std::array<float, kDescriptorSize>;
constexpr std::int32_t kLengthSquared = kDescriptorLength * kDescriptorLength;

std::int32_t product(const Descriptor& one, const Descriptor& other) {
  std::int32_t sum = 0;
  for (std::size_t i = 0; i < kDescriptorSize; ++i) sum += one[i] * other[i];
  return sum;
}

/// Bins that rise evenly from 0 to `highest`.
Histogram rising_histogram(float highest) {
  Histogram histogram{};
  for (std::size_t i = 0; i < kDescriptorSize; ++i)
    histogram[i] = highest * static_cast<float>(i) / (kDescriptorSize - 1);
  return histogram;
}

TEST(RootDescriptor, is_the_root_of_each_bins_share) {
  Histogram histogram{};
  histogram[3] = 1;
  histogram[70] = 4;
  histogram[127] = 4;
  const Descriptor descriptor = root_descriptor(histogram);
  EXPECT_EQ(descriptor[3], std::lround(512 / 3.0));  // sqrt(1 / 9)
  EXPECT_EQ(descriptor[70], std::lround(512 * 2 / 3.0));
  EXPECT_EQ(descriptor[127], std::lround(512 * 2 / 3.0));
  EXPECT_EQ(descriptor[0], 0);
}

TEST(RootDescriptor, is_512_long) {
  // Each of 128 bins is rounded by at most half, so the length is off by at most sqrt(128) / 2.
  const Descriptor descriptor = root_descriptor(rising_histogram(255));
  EXPECT_NEAR(std::sqrt(double(product(descriptor, descriptor))), kDescriptorLength,
              std::sqrt(128) / 2);
}

TEST(RootDescriptor, does_not_depend_on_contrast) {
  EXPECT_EQ(root_descriptor(rising_histogram(255)), root_descriptor(rising_histogram(1)));
}

TEST(RootDescriptor, of_nothing_is_zero_and_negative_bins_are_none) {
  EXPECT_EQ(root_descriptor(Histogram{}), Descriptor{});
  Histogram negative{};
  negative[5] = -3;
  EXPECT_EQ(root_descriptor(negative), Descriptor{});
  negative[6] = 2;
  EXPECT_EQ(root_descriptor(negative)[6], kDescriptorLength);
  EXPECT_EQ(root_descriptor(negative)[5], 0);
}

TEST(DescriptorDistance, is_euclidean_between_unit_vectors) {
  EXPECT_EQ(descriptor_distance(kLengthSquared), 0);
  EXPECT_EQ(descriptor_distance(kLengthSquared + 100), 0);  // rounded descriptors are a bit longer
  EXPECT_FLOAT_EQ(descriptor_distance(0), std::numbers::sqrt2_v<float>);
  EXPECT_FLOAT_EQ(descriptor_distance(-kLengthSquared), kNoSimilarFeature);
  EXPECT_FLOAT_EQ(descriptor_distance(kLengthSquared / 2), 1);  // 60 degrees
}

}  // namespace
}  // namespace roomcast::alignment
