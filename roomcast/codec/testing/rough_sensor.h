// SPDX-License-Identifier: Apache-2.0
// The simulated view of a structured-light sensor onto a floor 2 m to 5 m away, for tests only: its
// noise grows with the square of the distance and is in part shared by the pixels of a block.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::codec {

struct RoughSensor {
  int width = 320, height = 240;

  /// Without noise. The sensor has come nearer by `nearer_mm`; a person stands at 1.5 m, in front
  /// of the first `covered` columns.
  [[nodiscard]] DepthImage truth(double nearer_mm = 0, int covered = 0) const {
    DepthImage depth(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const double z_mm = x < covered ? 1500 : 2000 + 3000.0 * y / height;
        depth.at(x, y) = static_cast<std::uint16_t>(z_mm - nearer_mm);
      }
    }
    return depth;
  }

  /// The next reading; the person steps back by 15 mm in each.
  DepthImage reading(double nearer_mm = 0, int covered = 0) {
    constexpr int kSharedBy = 8;  // pixels, in both directions
    std::normal_distribution<double> gauss;
    DepthImage depth = truth(nearer_mm, covered);
    std::vector<double> shared(static_cast<std::size_t>((width + kSharedBy - 1) / kSharedBy));
    stepped_back_mm += 15;
    for (int y = 0; y < height; ++y) {
      if (y % kSharedBy == 0) {
        std::generate(shared.begin(), shared.end(), [&] { return gauss(random); });
      }
      for (int x = 0; x < width; ++x) {
        std::uint16_t& here = depth.at(x, y);
        const double z_mm = here + (x < covered ? stepped_back_mm : 0);
        const double noise =
            1.3 * shared[static_cast<std::size_t>(x / kSharedBy)] + 1.2 * gauss(random);
        here = static_cast<std::uint16_t>(z_mm + noise * z_mm * z_mm / 1e6);
      }
    }
    return depth;
  }

  std::mt19937 random{11};
  double stepped_back_mm = 0;
};

}  // namespace roomcast::codec
