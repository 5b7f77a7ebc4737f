// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/mask/steady_mask.h"

#include <algorithm>

namespace roomcast::codec {
namespace {

constexpr std::uint8_t kMostNeeded = 16;
constexpr std::uint8_t kCalmFrames = 90;

}  // namespace

MaskView SteadyMask::update(MaskView seen, DepthView depth_mm) {
  const bool first = shown_.empty();
  if (first) {
    shown_.resize(seen.width, seen.height);
    pixels_.resize(seen.width, seen.height);
  }
  for (int y = 0; y < seen.height; ++y) {
    const std::uint16_t* depth = depth_mm.row(y);
    const std::uint8_t* from = seen.row(y);
    std::uint8_t* shown = shown_.view().row(y);
    Pixel* pixels = pixels_.view().row(y);
    for (int x = 0; x < seen.width; ++x) {
      if (depth[x] != 0) step(pixels[x], from[x] != 0, shown[x]);
    }
  }
  return shown_;
}

void SteadyMask::step(Pixel& pixel, bool seen, std::uint8_t& shown) {
  pixel.run = seen && shown == 0 ? static_cast<std::uint8_t>(pixel.run + 1) : std::uint8_t{0};
  if (shown != 0 && !seen) {
    shown = 0;
    pixel.calm = 0;
  } else if (pixel.run >= pixel.needed) {
    shown = 255;
    pixel = {std::min<std::uint8_t>(kMostNeeded, static_cast<std::uint8_t>(2 * pixel.needed)), 0,
             0};
  } else if (pixel.calm < kCalmFrames) {
    ++pixel.calm;
  } else {
    pixel.needed = 1;
  }
}

}  // namespace roomcast::codec
