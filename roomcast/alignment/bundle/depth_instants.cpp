// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/bundle/depth_instants.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace roomcast::alignment {
namespace {

constexpr std::size_t kBlockPixels = std::size_t(kInstantBlock) * kInstantBlock;

/// Median of the readings of the block at this place; 0 if less than half of its pixels have one.
std::uint16_t block_median(const DepthImage& picture_mm, int left, int top) {
  std::array<std::uint16_t, kBlockPixels> readings{};
  std::size_t count = 0;
  for (int y = top; y < top + kInstantBlock; ++y) {
    for (int x = left; x < left + kInstantBlock; ++x) {
      const std::uint16_t reading = picture_mm.at(x, y);
      if (reading != 0) readings[count++] = reading;
    }
  }
  if (2 * count < kBlockPixels) return 0;
  const auto middle = readings.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(readings.begin(), middle, readings.begin() + static_cast<std::ptrdiff_t>(count));
  return *middle;
}

/// What is behind all that moves: nearly the farthest reading of each block.
DepthImage background_of(std::span<const DepthInstant> instants, double rank) {
  const DepthImage& first = instants[0].depth_mm;
  DepthImage background(first.width(), first.height());
  std::vector<std::uint16_t> readings;
  for (int y = 0; y < first.height(); ++y) {
    for (int x = 0; x < first.width(); ++x) {
      readings.clear();
      for (const DepthInstant& instant : instants) {
        if (instant.depth_mm.at(x, y) != 0) readings.push_back(instant.depth_mm.at(x, y));
      }
      if (readings.empty()) continue;
      const auto place = static_cast<std::ptrdiff_t>(rank * double(readings.size() - 1));
      std::nth_element(readings.begin(), readings.begin() + place, readings.end());
      background.at(x, y) = readings[static_cast<std::size_t>(place)];
    }
  }
  return background;
}

/// Without the blocks that few others adjoin.
MaskImage without_edges(const MaskImage& mask, int min_neighbours) {
  MaskImage kept(mask.width(), mask.height());
  for (int y = 1; y + 1 < mask.height(); ++y) {
    for (int x = 1; x + 1 < mask.width(); ++x) {
      if (mask.at(x, y) == 0) continue;
      int around = -1;  // the block itself
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) around += mask.at(x + dx, y + dy) != 0;
      }
      kept.at(x, y) = around >= min_neighbours ? 255 : 0;
    }
  }
  return kept;
}

}  // namespace

DepthImage depth_in_blocks(const DepthImage& picture_mm) {
  DepthImage blocks(picture_mm.width() / kInstantBlock, picture_mm.height() / kInstantBlock);
  for (int y = 0; y < blocks.height(); ++y) {
    for (int x = 0; x < blocks.width(); ++x)
      blocks.at(x, y) = block_median(picture_mm, kInstantBlock * x, kInstantBlock * y);
  }
  return blocks;
}

MaskImage in_front_of(const DepthImage& blocks_mm, const DepthImage& background_mm,
                      const DepthInstantOptions& options) {
  MaskImage mask(blocks_mm.width(), blocks_mm.height());
  for (int y = 0; y < blocks_mm.height(); ++y) {
    for (int x = 0; x < blocks_mm.width(); ++x) {
      const double z_m = 0.001 * blocks_mm.at(x, y);
      const double nearer_m = 0.001 * background_mm.at(x, y) - z_m;
      const double least_m = options.before_m + options.before_per_depth * z_m;
      mask.at(x, y) = z_m > 0 && nearer_m > least_m ? 255 : 0;
    }
  }
  return mask;
}

bool shows_motion(const MaskImage& mask) {
  const auto blocks = mask.view();
  const auto moving = std::count(blocks.data, blocks.data + blocks.pixel_count(), 255);
  return static_cast<std::size_t>(moving) >= kMinMovingBlocks;
}

void mark_moving(std::span<DepthInstant> instants, const DepthInstantOptions& options) {
  if (instants.empty()) return;
  const DepthImage background_mm = background_of(instants, options.background_rank);
  for (DepthInstant& instant : instants)
    instant.moving = without_edges(in_front_of(instant.depth_mm, background_mm, options),
                                   options.min_neighbours);
}

std::vector<DepthInstant> depth_instants(std::span<const DepthImage> pictures_mm,
                                         std::span<const double> times_s,
                                         const DepthInstantOptions& options) {
  std::vector<DepthInstant> instants;
  for (std::size_t i = 0; i < pictures_mm.size(); ++i)
    instants.push_back({times_s[i], depth_in_blocks(pictures_mm[i]), {}});
  mark_moving(instants, options);
  return instants;
}

}  // namespace roomcast::alignment
