// SPDX-License-Identifier: Apache-2.0
// Synthetic depth pictures for tests and golden files only: edge cases of the format, and scenes
// like a sensor's. The same bits on every machine (integers, fixed seeds).
#pragma once

#include <array>
#include <random>
#include <string>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::codec {

struct NamedDepth {
  std::string name;
  DepthImage depth_mm;
};

/// A slanted wall and a box in front of it, in 1 mm steps with noise, and holes along the box's
/// edges.
inline DepthImage synthetic_room(int width, int height, std::uint32_t seed) {
  std::mt19937 random(seed);
  DepthImage depth(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool box = x > width / 4 && x < width / 2 && y > height / 3;
      const bool edge = x == width / 4 || (x == width / 2 && y > height / 3);
      const int noise = static_cast<int>(random() % 7) - 3;
      const int z = (box ? 1200 + y : 2500 + 3 * x - y) + noise;
      const bool hole = edge || random() % 50 == 0;
      depth.at(x, y) = static_cast<std::uint16_t>(hole ? 0 : z);
    }
  }
  return depth;
}

/// A structured-light sensor: distances are quantised in steps that grow with the square of the
/// distance.
inline DepthImage synthetic_disparity_room(int width, int height) {
  DepthImage depth = synthetic_room(width, height, 3);
  for (std::size_t i = 0; i < depth.view().pixel_count(); ++i) {
    std::uint16_t& z = depth.data()[i];
    if (z != 0) z = static_cast<std::uint16_t>(350000 / (350000 / z));
  }
  return depth;
}

template <class ValueAt>
DepthImage depth_from(int width, int height, ValueAt value_at) {
  DepthImage depth(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) depth.at(x, y) = static_cast<std::uint16_t>(value_at(x, y));
  }
  return depth;
}

/// The edge cases, at one size.
inline std::vector<NamedDepth> synthetic_depths(int width, int height) {
  std::mt19937 random(7);
  std::vector<NamedDepth> all;
  all.push_back({"no_reading", DepthImage(width, height)});
  all.push_back({"farthest", DepthImage(width, height, 65535)});
  all.push_back({"nearest", DepthImage(width, height, 1)});
  all.push_back({"noise", depth_from(width, height, [&](int, int) { return random() & 0xFFFF; })});
  all.push_back({"extremes", depth_from(width, height, [&](int, int) {
                   return std::array{0, 1, 32767, 32768, 65535}[random() % 5];
                 })});
  all.push_back({"checkerboard",
                 depth_from(width, height, [](int x, int y) { return (x + y) % 2 ? 4000 : 0; })});
  all.push_back({"single_reading", depth_from(width, height, [&](int x, int y) {
                   return x == width / 2 && y == height / 2 ? 1234 : 0;
                 })});
  all.push_back({"single_hole", depth_from(width, height, [&](int x, int y) {
                   return x == width - 1 && y == height - 1 ? 0 : 1234;
                 })});
  all.push_back(
      {"ramp", depth_from(width, height, [](int x, int y) { return 500 + 60 * x + 9 * y; })});
  all.push_back({"room", synthetic_room(width, height, 1)});
  all.push_back({"disparity_room", synthetic_disparity_room(width, height)});
  return all;
}

}  // namespace roomcast::codec
