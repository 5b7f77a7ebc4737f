// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/depth_grid_color.h"

#include "roomcast/core/assert.h"

namespace roomcast::codec {

ColorImage color_in_depth_grid(ColorView color, int width, int height) {
  const int scale = width > 0 ? color.width / width : 0;
  ROOMCAST_ASSERT(color.width == scale * width && color.height == scale * height);
  const int count = scale * scale;
  ColorImage mean(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      int r = count / 2, g = count / 2, b = count / 2;
      for (int i = 0; i < count; ++i) {
        const Rgb8 one = color.at(scale * x + i % scale, scale * y + i / scale);
        r += one.r;
        g += one.g;
        b += one.b;
      }
      mean.at(x, y) = {static_cast<std::uint8_t>(r / count), static_cast<std::uint8_t>(g / count),
                       static_cast<std::uint8_t>(b / count)};
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
