// SPDX-License-Identifier: Apache-2.0
// Test fixture: frames of a sensor that looks at a slanted wall with a box before it, with noise,
// and with what foreign light may do to them. A function of the frame's number.
#pragma once

#include <cstdint>
#include <random>

#include "roomcast/core/image.h"

namespace roomcast::sensor {

inline constexpr double kWallFps = 30;

struct DisturbedWall {
  double lost = 0;      // share of the readings, in patches of 5 x 5, others in each frame
  double weak = 0;      // share of the readings, one by one
  double noise_mm = 3;  // standard deviation
  double off = 0;       // share of the readings that are off by half a metre, for one frame
  int width = 160, height = 120;

  [[nodiscard]] double true_mm(int x, int y) const {
    const bool on_box = x >= 60 && x < 90 && y >= 50 && y < 90;
    return on_box ? 1500 : 2500 + 2.0 * x;
  }

  [[nodiscard]] DepthImage frame(unsigned number) const {
    std::mt19937 random(number);
    std::normal_distribution<double> noise(0, noise_mm);
    std::uniform_real_distribution<double> share(0, 1);
    DepthImage depth_mm(width, height);
    Image<std::uint8_t> patch_lost(width / 5 + 1, height / 5 + 1);
    for (std::size_t i = 0; i < patch_lost.view().pixel_count(); ++i)
      patch_lost.data()[i] = share(random) < lost;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const double reading = true_mm(x, y) + noise(random) + (share(random) < off ? 500 : 0);
        const bool is_lost = patch_lost.at(x / 5, y / 5) != 0 || share(random) < weak;
        depth_mm.at(x, y) = is_lost ? 0 : static_cast<std::uint16_t>(reading);
      }
    }
    return depth_mm;
  }
};

}  // namespace roomcast::sensor
