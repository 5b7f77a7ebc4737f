// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/depth_grid_color.h"

#include <algorithm>
#include <cstddef>

#include "roomcast/codec/payload/payload_sections.h"
#include "roomcast/core/assert.h"

namespace roomcast::codec {

namespace {

std::uint8_t mean_of(unsigned a, unsigned b, unsigned c, unsigned d) {
  return static_cast<std::uint8_t>((a + b + c + d + 2) / 4);
}

/// The mean of each 2x2 pixels of two rows, channel by channel.
void halve(const Rgb8* upper, const Rgb8* lower, int width, Rgb8* out) {
  for (int x = 0; x < width; ++x, upper += 2, lower += 2) {
    const Rgb8 a = upper[0], b = upper[1], c = lower[0], d = lower[1];
    out[x] = {mean_of(a.r, b.r, c.r, d.r), mean_of(a.g, b.g, c.g, d.g),
              mean_of(a.b, b.b, c.b, d.b)};
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
