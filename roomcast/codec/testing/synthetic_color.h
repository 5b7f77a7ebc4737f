// SPDX-License-Identifier: Apache-2.0
// Synthetic colour pictures and masks that match synthetic_depth.h, for tests and golden files
// only.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "roomcast/codec/testing/synthetic_depth.h"

namespace roomcast::codec {

struct SyntheticFrame {
  DepthImage depth_mm;
  ColorImage color;  // black where not seen, as registration leaves it
  MaskImage seen;
};

/// A smooth pattern with a disc that moves with `frame`; the mask excludes holes, two bands and a
/// shadow.
inline SyntheticFrame synthetic_frame(int width, int height, int frame) {
  SyntheticFrame out;
  out.depth_mm = synthetic_room(width, height, 100 + static_cast<std::uint32_t>(frame));
  out.color = ColorImage(width, height);
  out.seen = MaskImage(width, height);
  const int disc_x = (width / 8 + 3 * frame) % width, disc_y = height / 2, radius = height / 5;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool band = y < height / 12 || y >= height - height / 12;
      const bool shadow = x > width / 2 && x < width / 2 + width / 20 + 2 && y > height / 3;
      if (out.depth_mm.at(x, y) == 0 || band || shadow) continue;
      const int dx = x - disc_x, dy = y - disc_y;
      const bool disc = dx * dx + dy * dy < radius * radius;
      out.seen.at(x, y) = 255;
      out.color.at(x, y) = disc ? Rgb8{200, 60, 40}
                                : Rgb8{static_cast<std::uint8_t>(60 + 120 * x / width),
                                       static_cast<std::uint8_t>(80 + 100 * y / height),
                                       static_cast<std::uint8_t>(150 - 60 * x / width)};
    }
  }
  return out;
}

/// Root mean square difference of all channels over the pixels that are seen.
inline double color_rms(const ColorImage& a, const ColorImage& b, const MaskImage& seen) {
  double sum = 0;
  std::int64_t count = 0;
  for (std::size_t i = 0; i < seen.view().pixel_count(); ++i) {
    if (!seen.data()[i]) continue;
    const int dr = a.data()[i].r - b.data()[i].r, dg = a.data()[i].g - b.data()[i].g,
              db = a.data()[i].b - b.data()[i].b;
    sum += dr * dr + dg * dg + db * db;
    count += 3;
  }
  return count ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

}  // namespace roomcast::codec
