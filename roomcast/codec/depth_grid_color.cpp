// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/depth_grid_color.h"

#include <algorithm>
#include <cstddef>

#include "roomcast/codec/payload/payload_sections.h"
#include "roomcast/core/assert.h"

namespace roomcast::codec {

namespace {

/// The mean of each 2x2 pixels of two rows, channel by channel.
void halve(const Rgb8* upper, const Rgb8* lower, int width, Rgb8* out) {
  static_assert(sizeof(Rgb8) == 3);
  const auto* a = reinterpret_cast<const std::uint8_t*>(upper);
  const auto* b = reinterpret_cast<const std::uint8_t*>(lower);
  auto* mean = reinterpret_cast<std::uint8_t*>(out);
  for (int x = 0; x < width; ++x, a += 6, b += 6, mean += 3) {
    for (int channel = 0; channel < 3; ++channel) {
      mean[channel] = static_cast<std::uint8_t>(
          (a[channel] + a[channel + 3] + b[channel] + b[channel + 3] + 2) / 4);
    }
  }
}

}  // namespace

ColorImage color_in_depth_grid(ColorView color, int width, int height) {
  const int scale = width > 0 ? color.width / width : 0;
  ROOMCAST_ASSERT(color.width == scale * width && color.height == scale * height);
  ROOMCAST_ASSERT(scale <= kMaxColorScale);
  ColorImage mean(width, height);
  for (int y = 0; y < height; ++y) {
    Rgb8* const out = mean.data() + static_cast<std::ptrdiff_t>(y) * width;
    if (scale == 1) {
      std::copy_n(color.row(y), width, out);
    } else {
      halve(color.row(2 * y), color.row(2 * y + 1), width, out);
    }
  }
  return mean;
}

std::shared_ptr<const DecodedFrame> with_color_in_depth_grid(
    std::shared_ptr<const DecodedFrame> frame) {
  const int width = frame->depth_mm.width(), height = frame->depth_mm.height();
  if (frame->color.empty() || frame->color.width() == width) return frame;
  auto coarse = std::make_shared<DecodedFrame>();
  coarse->depth_mm = frame->depth_mm;
  coarse->color_seen = frame->color_seen;
  coarse->color = color_in_depth_grid(frame->color, width, height);
  return coarse;
}

}  // namespace roomcast::codec
