// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/measure/still_surfaces.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace roomcast::bench {
namespace {

constexpr double kMinFrameShare = 0.9, kMinNearShare = 0.9;

/// Sorts the readings. 0 where they are not those of a still surface.
std::uint16_t still_median(std::vector<std::uint16_t>& readings, std::size_t frames) {
  const auto count = static_cast<double>(readings.size());
  if (readings.empty() || count < kMinFrameShare * static_cast<double>(frames)) return 0;
  std::sort(readings.begin(), readings.end());
  const std::uint16_t median = readings[readings.size() / 2];
  const auto near = std::count_if(readings.begin(), readings.end(), [median](std::uint16_t z) {
    return std::abs(z - median) <= kStillShare * median;
  });
  return static_cast<double>(near) < kMinNearShare * count ? std::uint16_t{0} : median;
}

}  // namespace

DepthImage median_of_still(std::span<const DepthView> frames) {
  if (frames.empty()) return {};
  DepthImage median(frames[0].width, frames[0].height);
  std::vector<std::uint16_t> readings;
  for (int y = 0; y < median.height(); ++y) {
    for (int x = 0; x < median.width(); ++x) {
      readings.clear();
      for (const DepthView& frame : frames) {
        if (frame.at(x, y) != 0) readings.push_back(frame.at(x, y));
      }
      median.at(x, y) = still_median(readings, frames.size());
    }
  }
  return median;
}

}  // namespace roomcast::bench
