// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/random/value_noise.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

TEST(ValueNoise, is_continuous_across_lattice_lines) {
  for (int i = -5; i < 5; ++i) {
    const float x = static_cast<float>(i);
    EXPECT_NEAR(value_noise({x - 1e-4F, 0.3F}, 7), value_noise({x + 1e-4F, 0.3F}, 7), 1e-3F);
  }
}

TEST(ValueNoise, differs_between_seeds) {
  EXPECT_NE(value_noise({0.4F, 0.6F}, 1), value_noise({0.4F, 0.6F}, 2));
}

TEST(ValueNoise, octaves_finer_than_the_footprint_vanish) {
  EXPECT_EQ(fractal_noise({0.31F, 0.17F}, 0.05F, 4, 0.06F, 3), 0.0F);
  EXPECT_NE(fractal_noise({0.31F, 0.17F}, 0.05F, 4, 0.001F, 3), 0.0F);
}

TEST(ValueNoise, values_of_one_hash_are_independent) {
  double correlation = 0.0;
  constexpr int kCount = 4000;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    correlation += (nth_unit(i, 1) - 0.5) * (nth_unit(i, 2) - 0.5);
  }
  // The mean of products of independent uniform numbers has standard deviation 1 / (12 sqrt(n)).
  EXPECT_LT(std::abs(correlation / kCount), 4.0 / (12.0 * std::sqrt(kCount)));
}

}  // namespace
}  // namespace roomcast::simulator
