// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/color_pairs.h"

#include <algorithm>
#include <chrono>

namespace roomcast::recording {
namespace {

constexpr double kSlowest_fps = 0.001, kFastest_fps = 240;

nanoseconds distance(nanoseconds a, nanoseconds b) {
  return a < b ? b - a : a - b;
}

}  // namespace

std::vector<std::optional<std::size_t>> nearest_colors(const std::vector<nanoseconds>& depth_times,
                                                       const std::vector<nanoseconds>& color_times,
                                                       nanoseconds tolerance) {
  std::vector<std::optional<std::size_t>> pairs(depth_times.size());
  for (std::size_t i = 0; i < depth_times.size() && !color_times.empty(); ++i) {
    const auto after = std::ranges::lower_bound(color_times, depth_times[i]);
    auto nearest = after == color_times.end() ? after - 1 : after;
    if (nearest != color_times.begin() &&
        distance(*(nearest - 1), depth_times[i]) <= distance(*nearest, depth_times[i]))
      --nearest;
    if (distance(*nearest, depth_times[i]) <= tolerance)
      pairs[i] = static_cast<std::size_t>(nearest - color_times.begin());
  }
  return pairs;
}

std::vector<std::optional<std::size_t>> nearest_colors(
    const std::vector<nanoseconds>& depth_times, const std::vector<nanoseconds>& color_times) {
  return nearest_colors(depth_times, color_times, median_gap(depth_times, kNominalGap) / 2);
}

nanoseconds median_gap(const std::vector<nanoseconds>& times, nanoseconds otherwise) {
  if (times.size() < 2) return otherwise;
  std::vector<nanoseconds> gaps(times.size() - 1);
  for (std::size_t i = 0; i < gaps.size(); ++i) gaps[i] = times[i + 1] - times[i];
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::ranges::nth_element(gaps, middle);
  return *middle;
}

double fps_of_gap(nanoseconds gap) {
  const double seconds = std::chrono::duration<double>(gap).count();
  return seconds > 0 ? std::clamp(1 / seconds, kSlowest_fps, kFastest_fps) : kFastest_fps;
}

}  // namespace roomcast::recording
