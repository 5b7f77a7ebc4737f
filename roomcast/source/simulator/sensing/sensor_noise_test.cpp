// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/sensing/sensor_noise.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast::sim {
namespace {

/// A wall straight ahead.
DepthPlate flat_plate(float z_m, float infrared) {
  constexpr int kSide = 64;
  return {Image<float>(kSide, kSide, z_m), Image<float>(kSide, kSide, 1.0F),
          Image<float>(kSide, kSide, infrared)};
}

struct Statistics {
  double mean = 0, deviation = 0, missing = 0;
};

Statistics statistics_of(const DepthNoise& noise, int frames) {
  DepthImage picture(64, 64);
  double sum = 0, squares = 0, count = 0, all = 0;
  for (int frame = 0; frame < frames; ++frame) {
    noise.read_plate(static_cast<std::uint32_t>(frame) * 7919U, picture.view());
    for (std::size_t i = 0; i < picture.view().pixel_count(); ++i, ++all) {
      const double value = picture.data()[i];
      if (value == 0) continue;
      sum += value;
      squares += value * value;
      ++count;
    }
  }
  const double mean = sum / count;
  return {mean, std::sqrt(squares / count - mean * mean), 1.0 - count / all};
}

TEST(SensorNoise, sigma_is_fankhausers_formula_at_the_reference_amplitude) {
  // amplitude = infrared / z^2 = 0.05 at 2 m: 1.5 - 1 + 1.2 mm.
  EXPECT_NEAR(axial_sigma_mm({2.0F, 1.0F, 0.2F, 2.0F}), 1.7F, 1e-4F);
}

TEST(SensorNoise, sigma_grows_with_distance_slant_and_darkness) {
  const PerfectReading near{1.5F, 1.0F, 0.5F, 1.5F};
  const PerfectReading far{4.0F, 1.0F, 0.5F, 4.0F};
  const PerfectReading slanted{1.5F, 0.3F, 0.5F, 1.5F};
  const PerfectReading dark{1.5F, 1.0F, 0.05F, 1.5F};
  EXPECT_GT(axial_sigma_mm(far), 2.0F * axial_sigma_mm(near));
  EXPECT_GT(axial_sigma_mm(slanted), axial_sigma_mm(near));
  EXPECT_GT(axial_sigma_mm(dark), axial_sigma_mm(near));
}

TEST(SensorNoise, readings_spread_by_sigma_around_the_truth) {
  const DepthPlate plate = flat_plate(3.0F, 0.5F);
  const GaussianTable gaussians(5);
  const Statistics seen = statistics_of(DepthNoise(plate, gaussians), 20);
  const double sigma = axial_sigma_mm({3.0F, 1.0F, 0.5F, 3.0F});
  EXPECT_NEAR(seen.mean, 3000.0, 4.0 * sigma / std::sqrt(20.0 * 64.0));  // rows share table entries
  const double with_rounding = std::sqrt(sigma * sigma + 1.0 / 12.0);
  EXPECT_NEAR(seen.deviation, with_rounding, 0.05 * with_rounding);
  EXPECT_EQ(seen.missing, 0.0);
}

TEST(SensorNoise, weak_signals_flicker) {
  const float half_lost = 0.004F * 9.0F;  // amplitude in the middle between none and safe, at 3 m
  const DepthPlate plate = flat_plate(3.0F, half_lost);
  const GaussianTable gaussians(5);
  const Statistics seen = statistics_of(DepthNoise(plate, gaussians), 20);
  const double expected = dropout_probability({3.0F, 1.0F, half_lost, 3.0F});
  EXPECT_NEAR(expected, 0.5, 1e-3);
  EXPECT_NEAR(seen.missing, expected, 4.0 * 0.5 / std::sqrt(20.0 * 64.0 * 64.0));
}

TEST(SensorNoise, nothing_is_read_at_grazing_angles_or_out_of_range) {
  EXPECT_EQ(dropout_probability({2.0F, 0.10F, 0.5F, 2.0F}), 1.0F);
  EXPECT_EQ(dropout_probability({0.4F, 1.0F, 0.5F, 0.4F}), 1.0F);
  EXPECT_EQ(dropout_probability({8.5F, 1.0F, 5.0F, 8.5F}), 1.0F);
  EXPECT_EQ(dropout_probability({2.0F, 1.0F, 0.0F, 2.0F}), 1.0F);
  EXPECT_EQ(dropout_probability({2.0F, 1.0F, 0.5F, 2.0F}), 0.0F);
}

TEST(SensorNoise, readings_beside_a_step_are_lost_mixed_or_right) {
  DepthPlate plate = flat_plate(2.0F, 0.5F);
  for (int y = 0; y < 64; ++y) {
    for (int x = 32; x < 64; ++x) plate.z_m.at(x, y) = 3.0F;
  }
  const GaussianTable gaussians(5);
  const DepthNoise noise(plate, gaussians);
  DepthImage picture(64, 64);
  int lost = 0, mixed = 0, right = 0;
  for (std::uint32_t frame = 0; frame < 40; ++frame) {
    noise.read_plate(frame * 7919U, picture.view());
    for (int y = 0; y < 64; ++y) {
      const int value = picture.at(31, y);
      ++(value == 0 ? lost : value > 2030 && value < 2970 ? mixed : right);
      EXPECT_GT(picture.at(20, y), 1970);  // away from the step nothing flies
      EXPECT_LT(picture.at(20, y), 2030);
    }
  }
  const double all = 40.0 * 64.0;
  EXPECT_NEAR(lost / all, 0.25, 0.04);
  EXPECT_NEAR(mixed / all, 0.25, 0.04);
  EXPECT_GT(right / all, 0.45);
}

TEST(SensorNoise, color_noise_keeps_the_mean_and_stays_in_range) {
  const GaussianTable gaussians(9);
  ColorImage picture(64, 64, Rgb8{100, 0, 255});
  add_color_noise(3, gaussians, picture.view());
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < picture.view().pixel_count(); ++i) {
    sum += picture.data()[i].r;
    squares += picture.data()[i].r * picture.data()[i].r;
    EXPECT_LT(picture.data()[i].g, 10);
    EXPECT_GT(picture.data()[i].b, 245);
  }
  const double mean = sum / (64.0 * 64.0);
  EXPECT_NEAR(mean, 100.0, 0.2);
  EXPECT_NEAR(std::sqrt(squares / (64.0 * 64.0) - mean * mean), 1.14, 0.1);  // 1.1 and rounding
}

}  // namespace
}  // namespace roomcast::sim
