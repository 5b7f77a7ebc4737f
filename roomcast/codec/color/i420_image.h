// SPDX-License-Identifier: Apache-2.0
// Y'CbCr 4:2:0 pictures, BT.709, limited range, as VP9 codes them (docs/spec/codec.md §3.1), and
// their conversion from and to 8-bit sRGB. Source of the matrix: Recommendation ITU-R BT.709-6,
// items 3.2 to 3.5.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::codec {

/// Three planes without gaps; the chroma planes have half the side, rounded up.
struct I420Image {
  Image<std::uint8_t> y, cb, cr;

  void resize(int width, int height) {
    y.resize(width, height, 16);
    cb.resize((width + 1) / 2, (height + 1) / 2, 128);
    cr.resize((width + 1) / 2, (height + 1) / 2, 128);
  }
};

/// Read-only planes, not owned.
struct I420View {
  ImageView<const std::uint8_t> y, cb, cr;
};

/// Overwrites `image` where `seen` is not 0; the rest is unchanged. A chroma sample is the mean of
/// its seen pixels. Sizes must be equal.
void convert_seen(ColorView color, MaskView seen, I420Image& image);

/// Converts to sRGB; chroma samples are repeated. Sizes must be equal.
void convert_to_rgb(const I420View& image, ImageView<Rgb8> color);

}  // namespace roomcast::codec
