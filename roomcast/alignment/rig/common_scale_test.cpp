// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/common_scale.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

TEST(CommonScale, factors_keep_their_ratios_and_have_the_mean_logarithm_zero) {
  const auto scales = in_common_scale({{1, 0}, {1.05, 0.01}, {1.03, 0.01}}, 0);
  EXPECT_NEAR(scales[1].factor / scales[0].factor, 1.05, 1e-12);
  EXPECT_NEAR(scales[2].factor / scales[0].factor, 1.03, 1e-12);
  EXPECT_NEAR(scales[0].factor * scales[1].factor * scales[2].factor, 1, 1e-12);
  EXPECT_EQ(scales[0].standard_error, 0);
  EXPECT_EQ(scales[1].standard_error, 0.01);
}

TEST(CommonScale, factors_that_are_not_determined_stay_one) {
  const auto scales = in_common_scale({{1, 0}, {1, 0}, {1.04, 0.01}}, 0);
  EXPECT_EQ(scales[1].factor, 1);
  EXPECT_NEAR(scales[0].factor, 1 / std::sqrt(1.04), 1e-12);
}

TEST(CommonScale, a_calibrated_sensor_has_the_true_scale) {
  const auto scales = in_common_scale({{1, 0}, {1, 0.01}, {1.04, 0.01}}, 0);
  EXPECT_EQ(scales[0].factor, 1);
  EXPECT_EQ(scales[2].factor, 1.04);
}

TEST(CommonScale, nothing_determined_changes_nothing) {
  const auto scales = in_common_scale({{1, 0}, {1, 0}}, 0);
  EXPECT_EQ(scales[0].factor, 1);
  EXPECT_EQ(scales[1].factor, 1);
}

/// Draws rigs of three sensors, whose ratios are known exactly, and compares.
TEST(CommonScale, the_error_is_as_large_as_said) {
  constexpr double kSigma = 0.03;
  constexpr int kRigs = 4000;
  std::mt19937 random(1);
  std::normal_distribution<double> error(0, kSigma);
  double squares = 0;
  for (int i = 0; i < kRigs; ++i) {
    const double of_origin = error(random), of_second = error(random), of_third = error(random);
    const auto found = in_common_scale(
        {{1, 0}, {std::exp(of_second - of_origin), 0.001}, {std::exp(of_third - of_origin), 0.001}},
        0);
    squares += std::pow(std::log(found[0].factor) - of_origin, 2);
  }
  // The RMS of so many draws is known to 1.1 %; calibrated sensors' own error adds 1 %.
  EXPECT_NEAR(std::sqrt(squares / kRigs) / common_scale_error(3, 1, kSigma), 1, 0.04);
}

TEST(CommonScale, calibrated_sensors_are_hardly_off) {
  EXPECT_DOUBLE_EQ(common_scale_error(4, 0, 0.03), 0.0025);
}

}  // namespace
}  // namespace roomcast::alignment
