// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/unit_noise.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

constexpr int kWidth = 512, kHeight = 424;

/// Mean of the products of pixels that are (`dx`, `dy`) apart.
double correlation(const Image<float>& noise, int dx, int dy) {
  double sum = 0, count = 0;
  for (int y = 0; y + dy < kHeight; ++y) {
    for (int x = 0; x + dx < kWidth; ++x, ++count)
      sum += static_cast<double>(noise.at(x, y) * noise.at(x + dx, y + dy));
  }
  return sum / count;
}

Image<float> noise_of(DepthPrinciple principle, std::uint32_t key) {
  Image<float> noise(kWidth, kHeight);
  fill_unit_noise(principle, key, GaussianTable(), noise.view());
  return noise;
}

TEST(UnitNoise, has_mean_0_and_deviation_1) {
  for (const auto principle : {DepthPrinciple::kTimeOfFlight, DepthPrinciple::kStereo}) {
    const Image<float> noise = noise_of(principle, 3);
    double sum = 0;
    for (std::size_t i = 0; i < noise.view().pixel_count(); ++i)
      sum += static_cast<double>(noise.data()[i]);
    EXPECT_NEAR(sum / (kWidth * kHeight), 0.0, 0.03);
    EXPECT_NEAR(correlation(noise, 0, 0), 1.0, 0.03);
  }
}

TEST(UnitNoise, of_time_of_flight_is_independent_from_pixel_to_pixel_and_frame_to_frame) {
  const double bound = 5.0 / std::sqrt(double{kWidth} * kHeight);
  const Image<float> noise = noise_of(DepthPrinciple::kTimeOfFlight, 3);
  for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}, {7, 3}})
    EXPECT_NEAR(correlation(noise, dx, dy), 0.0, bound);
  const Image<float> next = noise_of(DepthPrinciple::kTimeOfFlight, 4);
  double sum = 0;
  for (std::size_t i = 0; i < noise.view().pixel_count(); ++i)
    sum += static_cast<double>(noise.data()[i] * next.data()[i]);
  EXPECT_NEAR(sum / (kWidth * kHeight), 0.0, bound);
}

TEST(UnitNoise, of_stereo_is_correlated_over_the_window_and_not_beyond) {
  const Image<float> noise = noise_of(DepthPrinciple::kStereo, 3);
  EXPECT_GT(correlation(noise, 1, 0), 0.8);
  EXPECT_GT(correlation(noise, 0, 1), 0.8);
  EXPECT_NEAR(correlation(noise, 9, 0), 0.0, 0.04);
  EXPECT_NEAR(correlation(noise, 0, 9), 0.0, 0.04);
}

}  // namespace
}  // namespace roomcast::simulator
