// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/random/gaussian_table.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {
namespace {

TEST(GaussianTable, holds_the_quantiles_of_the_normal_distribution) {
  const GaussianTable table;
  const auto below = [&](double share) {
    return table.of_hash(static_cast<std::uint32_t>(share * 4294967295.0));
  };
  EXPECT_NEAR(below(0.5), 0.0, 1e-4);
  EXPECT_NEAR(below(0.841345), 1.0, 1e-3);
  EXPECT_NEAR(below(0.158655), -1.0, 1e-3);
  EXPECT_NEAR(below(0.977250), 2.0, 1e-3);
  EXPECT_NEAR(below(0.998650), 3.0, 5e-3);
  EXPECT_NEAR(below(0.0), -below(1.0), 1e-6);
  EXPECT_LT(below(1.0), 4.4);
}

TEST(GaussianTable, runs_have_mean_0_and_the_deviation_they_promise) {
  const GaussianTable table;
  double sum = 0, squares = 0, count = 0;
  for (std::uint32_t row = 0; row < 30; ++row) {
    const std::int8_t* run = table.shuffled_run(hash_of(9, row));
    for (std::size_t i = 0; i < GaussianTable::kRun; ++i, ++count) {
      sum += run[i];
      squares += run[i] * run[i];
    }
  }
  EXPECT_NEAR(sum / count, 0.0, 0.3);
  EXPECT_NEAR(std::sqrt(squares / count), GaussianTable::kRunScale, 0.3);
}

}  // namespace
}  // namespace roomcast::simulator
