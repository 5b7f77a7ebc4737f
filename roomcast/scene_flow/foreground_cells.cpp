// SPDX-License-Identifier: Apache-2.0
#include "roomcast/scene_flow/foreground_cells.h"

#include <algorithm>
#include <cstdlib>

#include "roomcast/core/assert.h"

namespace roomcast::scene_flow {
namespace {

constexpr int kNothing_mm = 65535;  // as a background: nothing is read there
// Pictures in a row that must agree before something becomes the background: something farther was
// hidden before, a lack of readings or something nearer may be passing.
constexpr int kOfFarther = 3, kOfNothing = 15, kOfNearer = 150;
constexpr int kMinPixels = 5;

/// How far before the background a surface must be to stand before it.
int gap_mm(int background_mm) {
  return std::max(60, background_mm * 3 / 100);
}

bool agree(int a_mm, int b_mm) {
  return std::abs(a_mm - b_mm) < gap_mm(std::min(a_mm, b_mm));
}

int needed(int candidate_mm, int background_mm) {
  if (candidate_mm == kNothing_mm) return kOfNothing;
  return candidate_mm > background_mm ? kOfFarther : kOfNearer;
}

}  // namespace

ForegroundFinder::ForegroundFinder(int width, int height)
    : pixels_(width, height), limits_mm_(cells_along(width), cells_along(height)) {}

bool ForegroundFinder::is_foreground(Pixel& pixel, int reading_mm) {
  const int seen_mm = reading_mm > 0 ? reading_mm : kNothing_mm;
  if (agree(seen_mm, pixel.background_mm)) {
    // A running mean, so that single readings count little.
    if (seen_mm != kNothing_mm)
      pixel.background_mm =
          static_cast<std::uint16_t>(pixel.background_mm + (seen_mm - pixel.background_mm) / 8);
    pixel.agreeing = 0;
    return false;
  }
  pixel.agreeing = agree(seen_mm, pixel.candidate_mm)
                       ? static_cast<std::uint8_t>(std::min(pixel.agreeing + 1, 255))
                       : std::uint8_t{1};
  pixel.candidate_mm = static_cast<std::uint16_t>(seen_mm);
  if (pixel.agreeing >= needed(seen_mm, pixel.background_mm)) {
    pixel.background_mm = static_cast<std::uint16_t>(seen_mm);
    pixel.agreeing = 0;
  }
  return reading_mm > 0 && reading_mm < pixel.background_mm - gap_mm(pixel.background_mm);
}

void ForegroundFinder::find(DepthView depth_mm, CellDepths& cells) {
  ROOMCAST_ASSERT(depth_mm.width == pixels_.width() && depth_mm.height == pixels_.height());
  cells.resize(limits_mm_.width(), limits_mm_.height());
  long readings = 0, foreground = 0;
  cell_count_ = 0;
  for (int cell_y = 0; cell_y < cells.height(); ++cell_y) {
    for (int cell_x = 0; cell_x < cells.width(); ++cell_x) {
      int sum_mm = 0, limit_mm = kNothing_mm, count = 0;
      const int right = std::min((cell_x + 1) * kCellPixels, depth_mm.width);
      const int lower = std::min((cell_y + 1) * kCellPixels, depth_mm.height);
      for (int y = cell_y * kCellPixels; y < lower; ++y) {
        for (int x = cell_x * kCellPixels; x < right; ++x) {
          Pixel& pixel = pixels_.at(x, y);
          const int reading_mm = depth_mm.at(x, y);
          readings += reading_mm > 0;
          if (is_foreground(pixel, reading_mm)) {
            sum_mm += reading_mm;
            ++count;
          }
          const int background_mm = pixel.background_mm;
          limit_mm = std::min(limit_mm, background_mm - gap_mm(background_mm));
        }
      }
      foreground += count;
      cell_count_ += count >= kMinPixels;
      const bool is_enough = count >= kMinPixels;
      const int mean_mm = is_enough ? sum_mm / count : 0;
      cells.at(cell_x, cell_y) =
          mean_mm <= kMaxDepth_mm ? static_cast<std::int16_t>(mean_mm) : std::int16_t{0};
      limits_mm_.at(cell_x, cell_y) = static_cast<float>(limit_mm);
    }
  }
  share_ = readings > 0 ? static_cast<double>(foreground) / static_cast<double>(readings) : 0;
}

}  // namespace roomcast::scene_flow
