// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/bundle/steady_depth.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include "roomcast/alignment/bundle/sample_stack.h"

namespace roomcast::alignment {
namespace {

constexpr double kNormalSigmaPerMad = 1.4826;
constexpr std::uint16_t kNoReading = std::numeric_limits<std::uint16_t>::max();

/// The medians of one row of sorted samples. Missing readings are 0 and are sorted to the front.
struct RowMedian {
  std::vector<std::uint16_t> median_mm;
  std::vector<std::size_t> missing;  // pictures without a reading, by pixel
};

void fill(SampleStack<std::uint16_t>& stack, std::span<const DepthImage> pictures_mm, int y) {
  for (std::size_t i = 0; i < pictures_mm.size(); ++i) {
    const auto row = pictures_mm[i].view();
    std::copy_n(row.row(y), row.width, stack.picture(i).begin());
  }
}

RowMedian median_of(SampleStack<std::uint16_t>& sorted, std::size_t pictures, std::size_t width) {
  RowMedian row{std::vector<std::uint16_t>(width), std::vector<std::size_t>(width)};
  for (std::size_t i = 0; i < pictures; ++i) {
    const auto samples = sorted.picture(i);
    for (std::size_t x = 0; x < width; ++x) row.missing[x] += samples[x] == 0;
  }
  for (std::size_t x = 0; x < width; ++x) {
    const std::size_t present = pictures - row.missing[x];
    if (2 * present <= pictures) continue;
    row.median_mm[x] = sorted.picture(row.missing[x] + present / 2)[x];
  }
  return row;
}

/// Replaces samples by their distances from the median; missing ones become the largest value.
void deviate(SampleStack<std::uint16_t>& stack, std::size_t pictures, const RowMedian& row) {
  for (std::size_t i = 0; i < pictures; ++i) {
    const auto samples = stack.picture(i);
    for (std::size_t x = 0; x < samples.size(); ++x) {
      const int deviation = std::abs(int(samples[x]) - int(row.median_mm[x]));
      samples[x] = samples[x] == 0 ? kNoReading : static_cast<std::uint16_t>(deviation);
    }
  }
}

bool is_steady(double deviation_mm, double depth_mm, const SteadyDepthOptions& options) {
  return kNormalSigmaPerMad * deviation_mm <=
         options.max_sigma_mm + options.max_sigma_per_depth * depth_mm;
}

}  // namespace

SteadyDepth steady_depth(std::span<const DepthImage> pictures_mm,
                         const SteadyDepthOptions& options) {
  ROOMCAST_ASSERT(!pictures_mm.empty());
  const std::size_t pictures = pictures_mm.size();
  const int width = pictures_mm[0].width(), height = pictures_mm[0].height();
  SteadyDepth steady{DepthImage(width, height), MaskImage(width, height)};
  SampleStack<std::uint16_t> stack(pictures, static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y) {
    fill(stack, pictures_mm, y);
    stack.sort();
    const RowMedian row = median_of(stack, pictures, static_cast<std::size_t>(width));
    deviate(stack, pictures, row);
    stack.sort();
    for (int x = 0; x < width; ++x) {
      const auto i = static_cast<std::size_t>(x);
      if (row.median_mm[i] == 0) continue;
      const auto deviation_mm = stack.picture((pictures - row.missing[i]) / 2)[i];
      const bool steady_here = is_steady(deviation_mm, row.median_mm[i], options);
      steady.depth_mm.at(x, y) = steady_here ? row.median_mm[i] : 0;
      steady.moving.at(x, y) = steady_here ? 0 : 255;
    }
  }
  return steady;
}

}  // namespace roomcast::alignment
