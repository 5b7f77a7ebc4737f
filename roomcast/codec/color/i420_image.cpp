// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/i420_image.h"

#include <algorithm>

namespace roomcast::codec {
namespace {

// All in 1/65536. Y' = 16 + 219/255 (Kr R + Kg G + Kb B); Kr = 0.2126, Kb = 0.0722.
constexpr int kShift = 16, kHalf = 1 << (kShift - 1);
constexpr int fixed(double value) {
  return static_cast<int>(value * (1 << kShift) + (value < 0 ? -0.5 : 0.5));
}
constexpr double kRed = 0.2126, kBlue = 0.0722, kGreen = 1 - kRed - kBlue;
constexpr double kLumaScale = 219.0 / 255, kChromaScale = 224.0 / 255;
constexpr double kCbScale = kChromaScale / (2 * (1 - kBlue)),
                 kCrScale = kChromaScale / (2 * (1 - kRed));

constexpr int kYr = fixed(kLumaScale * kRed), kYg = fixed(kLumaScale * kGreen),
              kYb = fixed(kLumaScale * kBlue);
constexpr int kCbR = fixed(-kRed * kCbScale), kCbB = fixed((1 - kBlue) * kCbScale),
              kCbG = -kCbR - kCbB;
constexpr int kCrR = fixed((1 - kRed) * kCrScale), kCrB = fixed(-kBlue * kCrScale),
              kCrG = -kCrR - kCrB;

constexpr int kRgbFromY = fixed(1 / kLumaScale);
constexpr int kRedFromCr = fixed(1 / kCrScale), kBlueFromCb = fixed(1 / kCbScale);
constexpr int kGreenFromCr = fixed(-kRed / kGreen / kCrScale);
constexpr int kGreenFromCb = fixed(-kBlue / kGreen / kCbScale);

std::uint8_t luma(Rgb8 c) {
  return static_cast<std::uint8_t>(16 + ((kYr * c.r + kYg * c.g + kYb * c.b + kHalf) >> kShift));
}

/// Sums of up to four pixels.
struct Block {
  int r = 0, g = 0, b = 0, count = 0;
  void add(Rgb8 c, std::uint8_t seen) {
    if (!seen) return;
    r += c.r;
    g += c.g;
    b += c.b;
    ++count;
  }
};

std::uint8_t chroma(int weighted_sum, int count) {
  return static_cast<std::uint8_t>(128 + ((weighted_sum / count + kHalf) >> kShift));
}

void convert_luma_row(const Rgb8* color, const std::uint8_t* seen, int width, std::uint8_t* y) {
  for (int x = 0; x < width; ++x) y[x] = seen[x] ? luma(color[x]) : y[x];
}

void convert_chroma_row(ColorView color, MaskView seen, int chroma_y, I420Image& image) {
  const int y0 = 2 * chroma_y, y1 = std::min(y0 + 1, color.height - 1);
  std::uint8_t* cb = image.cb.view().row(chroma_y);
  std::uint8_t* cr = image.cr.view().row(chroma_y);
  for (int x = 0; x < image.cb.width(); ++x) {
    const int x0 = 2 * x, x1 = std::min(x0 + 1, color.width - 1);
    Block block;  // at an odd edge the last pixels count twice, which does not change the mean
    block.add(color.at(x0, y0), seen.at(x0, y0));
    block.add(color.at(x1, y0), seen.at(x1, y0));
    block.add(color.at(x0, y1), seen.at(x0, y1));
    block.add(color.at(x1, y1), seen.at(x1, y1));
    if (block.count == 0) continue;
    cb[x] = chroma(kCbR * block.r + kCbG * block.g + kCbB * block.b, block.count);
    cr[x] = chroma(kCrR * block.r + kCrG * block.g + kCrB * block.b, block.count);
  }
}

std::uint8_t to_byte(int fixed_value) {
  return static_cast<std::uint8_t>(std::clamp((fixed_value + kHalf) >> kShift, 0, 255));
}

}  // namespace

void convert_seen(ColorView color, MaskView seen, I420Image& image) {
  for (int y = 0; y < color.height; ++y) {
    convert_luma_row(color.row(y), seen.row(y), color.width, image.y.view().row(y));
  }
  for (int y = 0; y < image.cb.height(); ++y) convert_chroma_row(color, seen, y, image);
}

void convert_to_rgb(const I420View& image, ImageView<Rgb8> color) {
  for (int y = 0; y < color.height; ++y) {
    const std::uint8_t* luma_row = image.y.row(y);
    const std::uint8_t* cb_row = image.cb.row(y / 2);
    const std::uint8_t* cr_row = image.cr.row(y / 2);
    Rgb8* out = color.row(y);
    for (int x = 0; x < color.width; ++x) {
      const int grey = kRgbFromY * (luma_row[x] - 16);
      const int cb = cb_row[x / 2] - 128, cr = cr_row[x / 2] - 128;
      out[x] = {to_byte(grey + kRedFromCr * cr),
                to_byte(grey + kGreenFromCb * cb + kGreenFromCr * cr),
                to_byte(grey + kBlueFromCb * cb)};
    }
  }
}

}  // namespace roomcast::codec
