// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/coarse_depth.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

namespace roomcast::sensor {
namespace {

constexpr int kColumns = 12, kRows = 9;
constexpr int kStep = 3;            // every third pixel of every third row is read
constexpr double kMinShown = 0.05;  // share of a cell's pixels with a reading
constexpr double kStray = 0.1;      // share of a cell's readings at either end
constexpr std::uint32_t kChange_cm = 15;
constexpr std::chrono::seconds kLookInterval{1}, kRepeatInterval{5};

std::uint32_t centimetres(std::uint16_t depth_mm) {
  return (depth_mm + 5U) / 10U;
}

void add_cell(DepthView depth_mm, int column, int row, std::vector<std::uint16_t>& readings,
              wire::pb::CoarseDepth& out) {
  readings.clear();
  int pixels = 0;
  for (int y = row * depth_mm.height / kRows; y < (row + 1) * depth_mm.height / kRows; y += kStep) {
    for (int x = column * depth_mm.width / kColumns; x < (column + 1) * depth_mm.width / kColumns;
         x += kStep) {
      ++pixels;
      if (const std::uint16_t reading = depth_mm.at(x, y); reading > 0) readings.push_back(reading);
    }
  }
  if (readings.empty() || static_cast<double>(readings.size()) < kMinShown * pixels) {
    out.add_near_cm(0);
    out.add_far_cm(0);
    return;
  }
  const auto at = [&](double share) {
    const auto nth = readings.begin() +
                     static_cast<std::ptrdiff_t>(share * static_cast<double>(readings.size() - 1));
    std::nth_element(readings.begin(), nth, readings.end());
    return centimetres(*nth);
  };
  out.add_near_cm(at(kStray));
  out.add_far_cm(at(1 - kStray));
}

bool differs(const wire::pb::CoarseDepth& a, const wire::pb::CoarseDepth& b) {
  const auto is_far = [](std::uint32_t x, std::uint32_t y) {
    return (x == 0) != (y == 0) || std::max(x, y) - std::min(x, y) > kChange_cm;
  };
  return !std::ranges::equal(a.near_cm(), b.near_cm(), std::not_fn(is_far)) ||
         !std::ranges::equal(a.far_cm(), b.far_cm(), std::not_fn(is_far));
}

}  // namespace

wire::pb::CoarseDepth coarse_depth(DepthView depth_mm) {
  wire::pb::CoarseDepth coarse;
  coarse.set_columns(kColumns);
  coarse.set_rows(kRows);
  std::vector<std::uint16_t> readings;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column)
      add_cell(depth_mm, column, row, readings, coarse);
  }
  return coarse;
}

std::optional<wire::pb::CoarseDepth> CoarseDepthReporter::add(DepthView depth_mm,
                                                              HostTime captured) {
  if (looked_ && captured - *looked_ < kLookInterval) return std::nullopt;
  looked_ = captured;
  auto coarse = coarse_depth(depth_mm);
  const bool must_repeat = !sent_ || captured - *sent_ >= kRepeatInterval;
  if (!must_repeat && !differs(coarse, last_)) return std::nullopt;
  sent_ = captured;
  last_ = coarse;
  return coarse;
}

}  // namespace roomcast::sensor
