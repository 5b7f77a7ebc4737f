// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/sensor_noise.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

constexpr int kNoiseWidth = 160, kNoiseHeight = 120;

double sigma_in(const SigmaCodes& codes, int depth_mm) {
  int knot = 0;
  while (sigma_knot_mm(knot + 1) <= depth_mm) ++knot;
  const double part = static_cast<double>(depth_mm - sigma_knot_mm(knot)) /
                      (sigma_knot_mm(knot + 1) - sigma_knot_mm(knot));
  const auto at = [&](int k) { return sigma_of_code(codes[static_cast<std::size_t>(k)]) / 256.0; };
  return at(knot) * (1 - part) + at(knot + 1) * part;
}

/// A floor from 1 m to 5 m; `sigma` is a function of the distance in metres.
template <class Sigma>
DepthImage floor_with_noise(Sigma sigma, std::mt19937& random) {
  std::normal_distribution<double> gauss;
  DepthImage depth(kNoiseWidth, kNoiseHeight);
  for (int y = 0; y < kNoiseHeight; ++y) {
    for (int x = 0; x < kNoiseWidth; ++x) {
      const double z = 1000 + 4000.0 * y / kNoiseHeight;
      depth.at(x, y) = static_cast<std::uint16_t>(std::lround(z + sigma(z / 1000) * gauss(random)));
    }
  }
  return depth;
}

TEST(SensorNoise, finds_noise_that_grows_with_distance) {
  std::mt19937 random(1);
  const auto sigma = [](double z) { return 1.5 + 0.5 * z * z; };
  SensorNoise noise;
  for (int frame = 0; frame < 12; ++frame) noise.observe(floor_with_noise(sigma, random));
  for (const int z : {1300, 2000, 3000, 4500}) {
    EXPECT_NEAR(sigma_in(noise.table(), z), sigma(z / 1000.0), 0.25 * sigma(z / 1000.0)) << z;
  }
}

TEST(SensorNoise, follows_a_sensor_whose_noise_changes_within_seconds) {
  constexpr int kFourSeconds = 120;
  std::mt19937 random(6);
  SensorNoise noise;
  for (const double sigma_mm : {3.0, 6.0, 3.0}) {
    const auto sigma = [sigma_mm](double) { return sigma_mm; };
    for (int i = 0; i < kFourSeconds; ++i) noise.observe(floor_with_noise(sigma, random));
    EXPECT_NEAR(sigma_in(noise.table(), 3000), sigma_mm, 0.2 * sigma_mm);
  }
}

TEST(SensorNoise, one_frame_is_enough_for_a_start) {
  std::mt19937 random(2);
  const auto sigma = [](double z) { return 2 * z; };
  SensorNoise noise;
  noise.observe(floor_with_noise(sigma, random));
  for (const int z : {1500, 3000}) {
    EXPECT_NEAR(sigma_in(noise.table(), z), sigma(z / 1000.0), 0.4 * sigma(z / 1000.0)) << z;
  }
}

TEST(SensorNoise, things_that_move_do_not_count) {
  std::mt19937 random(3);
  const auto sigma = [](double) { return 3.0; };
  SensorNoise noise;
  for (int frame = 0; frame < 12; ++frame) {
    DepthImage depth = floor_with_noise(sigma, random);
    for (int y = 0; y < kNoiseHeight; ++y) {
      for (int x = 10 * frame; x < 10 * frame + 30; ++x) depth.at(x, y) = 1000;
    }
    noise.observe(depth);
  }
  EXPECT_NEAR(sigma_in(noise.table(), 3000), 3, 1);
}

/// A floor as structured light reads it: quantised in 1/z, no other noise.
DepthImage stairs_mm(double factor = 1) {
  DepthImage depth(kNoiseWidth, kNoiseHeight);
  for (int y = 0; y < kNoiseHeight; ++y) {
    for (int x = 0; x < kNoiseWidth; ++x) {
      const double z = 1000 + 4000.0 * (y + x / double{kNoiseWidth}) / kNoiseHeight;
      const double disparity = std::floor(350000 / z);
      depth.at(x, y) = static_cast<std::uint16_t>(factor * 350000 / disparity);
    }
  }
  return depth;
}

void expect_steps(const SensorNoise& noise) {
  for (const int z : {2500, 4000}) {
    const double step = static_cast<double>(z) * z / 350000;
    EXPECT_GT(sigma_in(noise.table(), z), 0.25 * step) << z;
    EXPECT_LT(sigma_in(noise.table(), z), 1.2 * step) << z;
  }
}

TEST(SensorNoise, steps_of_structured_light_count_as_noise) {
  SensorNoise noise;
  for (int frame = 0; frame < 4; ++frame) noise.observe(stairs_mm());
  expect_steps(noise);
}

TEST(SensorNoise, a_few_readings_between_the_steps_do_not_hide_them) {
  std::mt19937 random(8);
  SensorNoise noise;
  for (int frame = 0; frame < 90; ++frame) {
    DepthImage depth = stairs_mm();
    for (int i = 0; i < kNoiseWidth * kNoiseHeight / 200; ++i) {
      auto& read = depth.at(static_cast<int>(random() % kNoiseWidth),
                            static_cast<int>(random() % kNoiseHeight));
      read = static_cast<std::uint16_t>(read + random() % 40);
    }
    noise.observe(depth);
  }
  expect_steps(noise);
}

TEST(SensorNoise, the_steps_of_an_earlier_depth_scale_are_forgotten) {
  SensorNoise noise;
  for (int frame = 0; frame < 90; ++frame) noise.observe(stairs_mm(1.03));
  for (int frame = 0; frame < 270; ++frame) noise.observe(stairs_mm());
  expect_steps(noise);
}

TEST(SensorNoise, without_noise_there_are_still_levels_for_every_distance) {
  SensorNoise noise;
  DepthImage depth(kNoiseWidth, kNoiseHeight);
  for (int y = 0; y < kNoiseHeight; ++y) {
    for (int x = 0; x < kNoiseWidth; ++x)
      depth.at(x, y) = static_cast<std::uint16_t>(500 + 60 * y + x);
  }
  for (int frame = 0; frame < 4; ++frame) noise.observe(depth);
  DepthDomain domain;
  domain.set(noise.table());
  EXPECT_LT(domain.level_of(65535), kMaxLevel);
}

TEST(SensorNoise, has_usable_values_before_the_first_frame) {
  const SigmaCodes codes = SensorNoise().table();
  EXPECT_GT(sigma_in(codes, 1000), 0.5);
  EXPECT_LT(sigma_in(codes, 1000), 5);
  EXPECT_GT(sigma_in(codes, 8000), sigma_in(codes, 1000));
}

TEST(SensorNoise, a_picture_of_another_size_starts_anew) {
  std::mt19937 random(4);
  SensorNoise noise;
  noise.observe(floor_with_noise([](double) { return 3.0; }, random));
  noise.observe(DepthImage(32, 16, 2000));
  EXPECT_LT(sigma_in(noise.table(), 2000), 20);
}

}  // namespace
}  // namespace roomcast::codec
