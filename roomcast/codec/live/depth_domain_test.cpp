// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/depth_domain.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

SigmaCodes constant(double sigma_mm) {
  SigmaCodes codes;
  codes.fill(code_of_sigma(sigma_mm));
  return codes;
}

/// Noise that grows with the square of the distance, as a structured-light sensor's does.
SigmaCodes quadratic() {
  SigmaCodes codes;
  for (int knot = 0; knot < kSigmaKnotCount; ++knot) {
    const double z = sigma_knot_mm(knot) / 1000.0;
    codes[static_cast<std::size_t>(knot)] = code_of_sigma(1.5 * z * z);
  }
  return codes;
}

TEST(DepthDomain, codes_are_within_three_percent) {
  for (double sigma = 0.1; sigma < 3000; sigma *= 1.07) {
    EXPECT_NEAR(sigma_of_code(code_of_sigma(sigma)) / 256.0, sigma, 0.032 * sigma);
  }
}

TEST(DepthDomain, knots_run_from_a_quarter_metre_to_the_end) {
  EXPECT_EQ(sigma_knot_mm(0), 256);
  EXPECT_EQ(sigma_knot_mm(1), 320);
  EXPECT_EQ(sigma_knot_mm(kSigmaKnotCount - 1), 65536);
}

TEST(DepthDomain, eight_levels_are_one_sigma) {
  DepthDomain domain;
  domain.set(constant(4));
  EXPECT_NEAR(domain.level_of(3004) - domain.level_of(3000), 8, 1);
  EXPECT_NEAR(domain.level_of(5000) - domain.level_of(1000), 8000, 260);
}

TEST(DepthDomain, no_reading_stays_no_reading_and_nothing_else_becomes_one) {
  DepthDomain domain;
  domain.set(quadratic());
  EXPECT_EQ(domain.level_of(0), 0);
  EXPECT_EQ(domain.mm_of(0), 0);
  for (int v = 1; v < 65536; ++v) {
    ASSERT_NE(domain.level_of(static_cast<std::uint16_t>(v)), 0) << v;
    ASSERT_NE(domain.mm_of(static_cast<std::uint16_t>(v)), 0) << v;
  }
}

TEST(DepthDomain, levels_rise_with_distance) {
  DepthDomain domain;
  domain.set(quadratic());
  for (int z = 2; z < 65536; ++z) {
    ASSERT_GE(domain.level_of(static_cast<std::uint16_t>(z)),
              domain.level_of(static_cast<std::uint16_t>(z - 1)));
  }
}

TEST(DepthDomain, there_and_back_is_off_by_half_a_level_at_most) {
  DepthDomain domain;
  domain.set(quadratic());
  for (int z = 300; z < 20000; ++z) {
    const int back = domain.mm_of(domain.level_of(static_cast<std::uint16_t>(z)));
    const double sigma = 1.5 * z / 1000.0 * z / 1000.0;
    ASSERT_LE(std::abs(back - z), 1 + 0.55 * sigma / kLevelsPerSigma) << z;
  }
}

}  // namespace
}  // namespace roomcast::codec
