// SPDX-License-Identifier: Apache-2.0
// The simulated view of a fixed sensor, for tests only: a slanted wall, a static post, a moving
// ball, noise that grows with distance, flicker at edges. The same bits on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>

#include "roomcast/core/image.h"

namespace roomcast::codec {

struct SyntheticMotion {
  int width = 128, height = 96;
  double ball_speed = 3;        // pixels a frame
  double ball_approach_mm = 0;  // a frame
  bool noise = true;
  std::uint32_t seed = 5;

  [[nodiscard]] DepthImage truth(int frame) const {
    DepthImage depth(width, height);
    const double ball_x = 20 + ball_speed * frame, ball_y = height * 0.5, radius = height * 0.25;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        double z = 2800 + 3.0 * x - 2.0 * y;
        if (x > width * 3 / 4 && x < width * 3 / 4 + 9) z = 1900 + y;
        const double dx = x - ball_x, dy = y - ball_y, inside = radius * radius - dx * dx - dy * dy;
        if (inside > 0) z = 1500 - ball_approach_mm * frame - 4 * std::sqrt(inside);
        depth.at(x, y) = static_cast<std::uint16_t>(z + 0.5);
      }
    }
    return depth;
  }

  [[nodiscard]] DepthImage reading(int frame) const {
    const DepthImage exact = truth(frame);
    DepthImage depth = exact;
    if (!noise) return depth;
    std::mt19937 random(seed + 977 * static_cast<std::uint32_t>(frame));
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const int z = exact.at(x, y);
        const double sigma = 1.5 + 0.3 * (z / 1000.0) * (z / 1000.0);
        double sum = 0;  // of four uniform numbers: nearly Gaussian, variance 1/3
        for (int i = 0; i < 4; ++i) sum += static_cast<double>(random() % 1000) / 1000 - 0.5;
        const bool edge = x > 0 && std::abs(z - exact.at(x - 1, y)) > 100;
        const bool lost = random() % 500 == 0 || (edge && random() % 3 == 0);
        depth.at(x, y) = static_cast<std::uint16_t>(lost ? 0 : z + sigma * sum * 1.732 + 0.5);
      }
    }
    return depth;
  }

  /// The first reading after the sensor has moved nearer.
  [[nodiscard]] DepthImage reading_from_nearer(int by_mm) const {
    DepthImage depth = reading(0);
    for (std::size_t i = 0; i < depth.view().pixel_count(); ++i) {
      std::uint16_t& z = depth.data()[i];
      if (z != 0) z = static_cast<std::uint16_t>(z - by_mm);
    }
    return depth;
  }
};

}  // namespace roomcast::codec
