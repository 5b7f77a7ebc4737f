// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/color_response.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/core/srgb.h"
#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {
namespace {

ColorImage exposed(const ColorImage& light, const ColorResponse& response, std::uint32_t key = 3) {
  ColorImage out(light.width(), light.height());
  response.expose(light, key, GaussianTable(), out.view());
  return out;
}

TEST(ColorResponse, gain_1_without_noise_changes_nothing) {
  ColorImage light(256, 1);
  for (int i = 0; i < 256; ++i) {
    const auto level = static_cast<std::uint8_t>(i);
    light.at(i, 0) = {level, level, level};
  }
  EXPECT_EQ(exposed(light, ColorResponse({1, 1, 1}, false)), light);
}

TEST(ColorResponse, gain_multiplies_linear_light_channel_by_channel) {
  const ColorImage light(4, 4, {100, 100, 250});
  const Rgb8 out = exposed(light, ColorResponse({1.2F, 0.8F, 2.0F}, false)).at(1, 1);
  EXPECT_NEAR(linear_from_level(out.r), 1.2F * linear_from_level(100), 0.003F);
  EXPECT_NEAR(linear_from_level(out.g), 0.8F * linear_from_level(100), 0.003F);
  EXPECT_EQ(out.b, 255);
}

TEST(ColorResponse, noise_has_the_deviation_of_the_photon_transfer_model_and_keeps_the_mean) {
  for (const std::uint8_t level : {40, 128, 220}) {
    const ColorImage light(256, 256, {level, level, level});
    const ColorImage out = exposed(light, ColorResponse({1, 1, 1}, true));
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < out.view().pixel_count(); ++i) {
      const double error = out.data()[i].g - level;
      sum += error;
      squares += error * error;
    }
    const double count = static_cast<double>(out.view().pixel_count());
    const double sigma = ColorResponse::sigma_at_level(level);
    EXPECT_NEAR(sum / count, 0.0, 0.05);
    EXPECT_NEAR(std::sqrt(squares / count), std::sqrt(sigma * sigma + 1.0 / 12.0), 0.08 * sigma);
    EXPECT_GT(sigma, 0.5);
    EXPECT_LT(sigma, 2.0);
  }
}

TEST(ColorResponse, channels_and_frames_have_noise_of_their_own) {
  const ColorImage light(64, 64, {120, 120, 120});
  const ColorImage one = exposed(light, ColorResponse({1, 1, 1}, true), 1);
  EXPECT_NE(one, exposed(light, ColorResponse({1, 1, 1}, true), 2));
  int alike = 0;
  for (std::size_t i = 0; i < one.view().pixel_count(); ++i)
    alike += one.data()[i].r == one.data()[i].g;
  EXPECT_LT(alike, 64 * 64 / 2);
}

TEST(ColorResponse, levels_and_light_are_inverse) {
  for (int level = 0; level < 256; ++level) {
    EXPECT_NEAR(level_from_linear(linear_from_level(static_cast<float>(level))), level, 1e-2);
  }
  EXPECT_NEAR(mean_brightness(ColorImage(3, 3, {255, 255, 255})), 1.0F, 1e-4F);
}

}  // namespace
}  // namespace roomcast::simulator
