// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/shutter.h"

#include <numeric>

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

/// A bright bar that moves to the right by `step` pixels from instant to instant.
std::array<ColorImage, kShutterInstants> moving_bar(int step) {
  std::array<ColorImage, kShutterInstants> lights;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    lights[i] = ColorImage(60, 40);
    const int left = 10 + step * static_cast<int>(i);
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 60; ++x) {
        const auto level = static_cast<std::uint8_t>(x >= left && x < left + 6 ? 200 : 20);
        lights[i].at(x, y) = {level, level, level};
      }
    }
  }
  return lights;
}

/// The mean column of the bar's extra light in a row.
double middle_of(const ColorImage& picture, int y) {
  double sum = 0, weighted = 0;
  for (int x = 0; x < picture.width(); ++x) {
    const double extra = picture.at(x, y).r - 20.0;
    sum += extra;
    weighted += extra * x;
  }
  return weighted / sum;
}

ColorImage shuttered(const Shutter& shutter, int step) {
  ColorImage out(60, 40);
  expose_rows(shutter, moving_bar(step), out.view());
  return out;
}

TEST(Shutter, weights_sum_to_one_and_move_down_the_picture) {
  const Shutter shutter{0.030F, 0.010F};
  float earlier = -1;
  for (const float share : {0.0F, 0.5F, 1.0F}) {
    const auto weights = shutter.weights(share);
    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0F), 1.0F, 1e-5F);
    float middle = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) middle += weights[i] * static_cast<float>(i);
    EXPECT_GT(middle, earlier);
    earlier = middle;
  }
}

TEST(Shutter, instants_are_centred_and_span_readout_and_exposure) {
  const auto instants = Shutter{0.030F, 0.020F}.instants();
  EXPECT_EQ(instants[kShutterInstants / 2].count(), 0);
  EXPECT_NEAR(static_cast<double>((instants.back() - instants.front()).count()), 0.04e9, 1e3);
}

TEST(Shutter, rolling_bends_what_moves) {
  const ColorImage bent = shuttered({0.040F, 0.001F}, 4);
  EXPECT_GT(middle_of(bent, 38) - middle_of(bent, 1), 10);
  const ColorImage still = shuttered({0.040F, 0.001F}, 0);
  EXPECT_NEAR(middle_of(still, 38), middle_of(still, 1), 1e-9);
}

TEST(Shutter, a_long_exposure_blurs_what_moves_and_nothing_else) {
  const auto brightest = [](const ColorImage& picture) {
    int level = 0;
    for (int x = 0; x < picture.width(); ++x) level = std::max<int>(level, picture.at(x, 20).r);
    return level;
  };
  EXPECT_LT(brightest(shuttered({0.0F, 0.040F}, 6)), 150);
  EXPECT_EQ(brightest(shuttered({0.0F, 0.040F}, 0)), 200);
}

}  // namespace
}  // namespace roomcast::simulator
