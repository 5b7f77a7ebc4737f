// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/noise_law.h"

#include <gtest/gtest.h>

#include "roomcast/simulator/sensing/depth_sensing.h"

namespace roomcast::simulator {
namespace {

SensorProfile drawn(CameraModel model, std::uint32_t seed) {
  Random random(seed);
  return with_drawn_noise(profile_of(model, true), random);
}

/// Standard deviation of a reading of a surface that faces the sensor.
double sigma_mm(const SensorProfile& profile, float z_m, float infrared) {
  DepthReading reading;
  reading.z_m = z_m;
  reading.infrared = infrared;
  return DepthSensing(profile, DepthBias()).expect(reading, 0, 0).sigma_mm;
}

TEST(NoiseLaw, time_of_flight_is_noisier_where_less_light_returns) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const SensorProfile profile = drawn(CameraModel::kKinect2, seed);
    const double amplitude_part = sigma_mm(profile, 3, 0.1F) / sigma_mm(profile, 3, 0.5F);
    EXPECT_GT(amplitude_part, 2.0) << "more than by the square root";
    EXPECT_GT(sigma_mm(profile, 3, 0.5F),
              sigma_mm(profile_of(CameraModel::kKinect2, true), 3, 0.5F));
  }
}

TEST(NoiseLaw, time_of_flight_wiggles_by_millimetres_over_range) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const SensorProfile profile = drawn(CameraModel::kAzure, seed);
    const DepthBias bias(profile, seed);
    float lowest = 1e9F, highest = -1e9F;
    for (float z_m = 2; z_m < 3; z_m += 0.01F) {
      lowest = std::min(lowest, bias.at(300, 300, z_m));
      highest = std::max(highest, bias.at(300, 300, z_m));
    }
    EXPECT_GT(highest - lowest, 2 * 4.0F * 0.95F);
    EXPECT_LT(highest - lowest, 2 * 15.0F * 1.01F);
  }
}

TEST(NoiseLaw, structured_light_is_noisier_with_the_square_of_the_range) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const SensorProfile profile = drawn(CameraModel::kKinect1, seed);
    EXPECT_NEAR(sigma_mm(profile, 4, 0.5F) / sigma_mm(profile, 2, 0.5F), 4, 0.01);
    const double at_3_m = sigma_mm(profile, 3, 0.5F);
    EXPECT_GT(at_3_m, 7);  // published: 13 mm
    EXPECT_LT(at_3_m, 20);
  }
}

TEST(NoiseLaw, units_differ) {
  EXPECT_NE(drawn(CameraModel::kKinect1, 1).subpixel, drawn(CameraModel::kKinect1, 2).subpixel);
  EXPECT_NE(drawn(CameraModel::kAzure, 1).farthest_m, drawn(CameraModel::kAzure, 2).farthest_m);
}

}  // namespace
}  // namespace roomcast::simulator
