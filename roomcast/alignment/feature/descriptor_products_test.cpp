// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/descriptor_products.h"

#include <random>

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

std::vector<Descriptor> random_bins(std::size_t count) {
  std::mt19937 random(5);
  std::vector<Descriptor> descriptors(count);
  for (Descriptor& descriptor : descriptors) {
    for (std::int16_t& bin : descriptor) bin = static_cast<std::int16_t>(random() % 513);
  }
  return descriptors;
}

TEST(DescriptorProducts, the_reference_sums_over_all_bins) {
  Descriptor ones{}, counted{};
  for (std::size_t i = 0; i < kDescriptorSize; ++i) {
    ones[i] = 1;
    counted[i] = static_cast<std::int16_t>(i);
  }
  std::int32_t product = 0;
  descriptor_products_reference(ones, {&counted, 1}, {&product, 1});
  EXPECT_EQ(product, 127 * 128 / 2);
}

TEST(DescriptorProducts, fast_ones_equal_the_reference_for_every_count) {
  // Four at a time, and the rest one by one.
  const auto all = random_bins(kDescriptorTile);
  for (const std::size_t count : {0, 1, 3, 4, 5, 7, 8, 95, 96}) {
    const std::span<const Descriptor> others(all.data(), count);
    std::vector<std::int32_t> fast(count + 1, -1), plain(count + 1, -1);
    descriptor_products(all[0], others, fast);
    descriptor_products_reference(all[0], others, plain);
    EXPECT_EQ(fast, plain) << count;
    EXPECT_EQ(fast[count], -1);  // writes no more than asked for
  }
}

TEST(DescriptorProducts, the_largest_do_not_overflow) {
  Descriptor largest;
  largest.fill(kDescriptorLength);
  const std::vector<Descriptor> others(4, largest);
  std::vector<std::int32_t> products(4);
  descriptor_products(largest, others, products);
  EXPECT_EQ(products, std::vector<std::int32_t>(4, 128 * 512 * 512));
}

TEST(DescriptorProducts, keep_signs) {
  Descriptor positive, negative;
  positive.fill(300);
  negative.fill(-200);
  const std::vector<Descriptor> others(5, negative);
  std::vector<std::int32_t> products(5);
  descriptor_products(positive, others, products);
  EXPECT_EQ(products, std::vector<std::int32_t>(5, -128 * 300 * 200));
}

}  // namespace
}  // namespace roomcast::alignment
