// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/depth_bias.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

TEST(DepthBias, none_is_none) {
  EXPECT_EQ(DepthBias().at(3, 4, 2.0F), 0.0F);
}

TEST(DepthBias, of_time_of_flight_stays_within_the_profiles_amounts_and_is_smooth) {
  const SensorProfile profile = profile_of(CameraModel::kKinect2, false);
  const float most = profile.bias_offset_mm + profile.bias_wave_mm + profile.bias_wiggle_mm;
  float largest = 0;
  for (std::uint32_t unit = 0; unit < 5; ++unit) {
    const DepthBias bias(profile, unit);
    for (int y = 0; y < 424; y += 8) {
      for (int x = 1; x < 512; x += 8) {
        largest = std::max(largest, std::abs(bias.at(x, y, 2.5F)));
        EXPECT_LT(std::abs(bias.at(x, y, 2.5F) - bias.at(x - 1, y, 2.5F)), 0.06F);
      }
    }
  }
  EXPECT_LE(largest, most);
  constexpr float kMeasured_mm = 10.0F;  // for a lone wall, up to 4.5 m: Brogli 2016
  EXPECT_LE(most, kMeasured_mm);
  EXPECT_GT(largest, 0.3F * most);
}

TEST(DepthBias, wiggles_over_range_with_its_wavelength) {
  const SensorProfile profile = profile_of(CameraModel::kKinect2, false);
  const DepthBias bias(profile, 3);
  EXPECT_NEAR(bias.at(9, 9, 2.0F), bias.at(9, 9, 2.468F), 0.01F);
  EXPECT_GT(std::abs(bias.at(9, 9, 2.0F) - bias.at(9, 9, 2.234F)) +
                std::abs(bias.at(9, 9, 2.117F) - bias.at(9, 9, 2.351F)),
            2.0F);
}

TEST(DepthBias, of_stereo_grows_with_the_square_of_the_range) {
  const DepthBias bias(profile_of(CameraModel::kD435, false), 3);
  EXPECT_NEAR(bias.at(100, 100, 4.0F), 4.0F * bias.at(100, 100, 2.0F), 1e-3F);
}

TEST(DepthBias, differs_between_units) {
  const SensorProfile profile = profile_of(CameraModel::kKinect2, false);
  EXPECT_NE(DepthBias(profile, 1).at(50, 50, 2.0F), DepthBias(profile, 2).at(50, 50, 2.0F));
}

}  // namespace
}  // namespace roomcast::simulator
