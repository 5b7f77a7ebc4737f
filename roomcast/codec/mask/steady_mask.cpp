// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/mask/steady_mask.h"

#include <algorithm>

namespace roomcast::codec {
namespace {

constexpr std::uint8_t kMinNeeded = 6, kMaxToHide = 32, kMaxToShow = 4;
constexpr std::uint8_t kStaticFrames = 120;

}  // namespace

MaskView SteadyMask::update(MaskView seen, DepthView depth_mm) {
  if (shown_.empty()) begin(seen);
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

void SteadyMask::begin(MaskView seen) {
  shown_.resize(seen.width, seen.height);
  pixels_.resize(seen.width, seen.height);
  for (int y = 0; y < seen.height; ++y) {
    for (int x = 0; x < seen.width; ++x) shown_.at(x, y) = seen.at(x, y) != 0 ? 255 : 0;
  }
}

void SteadyMask::step(Pixel& pixel, bool seen, std::uint8_t& shown) {
  if (seen == (shown != 0)) {
    pixel.against = 0;
    if (++pixel.agreeing == kStaticFrames) {
      pixel.agreeing = 0;
      pixel.needed = std::max<std::uint8_t>(kMinNeeded, pixel.needed / 2);
    }
    return;
  }
  pixel.agreeing = 0;
  const std::uint8_t needed = seen ? std::min(pixel.needed, kMaxToShow) : pixel.needed;
  if (++pixel.against < needed) return;
  shown = seen ? 255 : 0;
  pixel.against = 0;
  pixel.needed = std::min<std::uint8_t>(kMaxToHide, static_cast<std::uint8_t>(2 * pixel.needed));
}

}  // namespace roomcast::codec
