// SPDX-License-Identifier: Apache-2.0
#include "bench/model/color_step.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

/// Two views of a room of 4 x 4 m; the second is 20 % brighter.
std::vector<model::SharedColor> two_exposures() {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-2, 2), level(60, 140);
  std::vector<model::SharedColor> shared;
  for (int i = 0; i < 4'000; ++i) {
    const Eigen::Vector3f color = Eigen::Vector3f::Constant(level(random));
    shared.push_back({0, 1, {place(random), 0, place(random)}, color, 1.2F * color});
  }
  return shared;
}

TEST(ColorStep, is_the_difference_of_exposures_and_gone_with_gains) {
  const ColorSteps steps = color_steps(two_exposures(), 2);
  EXPECT_EQ(steps.pairs, 1u);
  EXPECT_NEAR(steps.before.mean, 20, 1.5);
  EXPECT_EQ(steps.before.mean, steps.before.largest);
  EXPECT_LT(steps.after.largest, 0.3);
}

TEST(ColorStep, stays_where_half_of_the_room_is_lit_otherwise) {
  auto shared = two_exposures();
  for (model::SharedColor& place : shared)
    if (((place.at_m / 0.5F).array().floor().cast<int>().sum() & 1) != 0)
      place.color_b = place.color_a;
  EXPECT_GT(color_steps(shared, 2).after.largest, 10)
      << "gains of one half are judged in the other";
}

TEST(ColorStep, there_is_none_without_shared_places) {
  EXPECT_EQ(color_steps({}, 3).pairs, 0u);
}

}  // namespace
}  // namespace roomcast::bench
