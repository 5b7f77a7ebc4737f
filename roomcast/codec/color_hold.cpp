// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color_hold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace roomcast::codec {
namespace {

constexpr int kSide = 8;    // of a block, luma pixels
constexpr int kScale = 16;  // of means
constexpr int kRefineShift = 3;
constexpr int kShownReach = kScale;  // a mean this far from what is shown is shown

// A block is still when neither its sum nor any small part of it says otherwise.
constexpr double kPixelSigmas = 4, kSumSigmas = 4;
constexpr int kMostStrayPixels = 2;

constexpr double kMadToSigma = 1.4826;
constexpr double kNoiseStep = 0.1;
constexpr double kLeastSigma = 0.5, kMostSigma = 8;

/// Part of a plane, inside the picture.
struct Part {
  int x0, y0, x1, y1;
};
Part part_of(const Image<std::uint8_t>& plane, int block_x, int block_y, int side) {
  return {block_x * side, block_y * side, std::min((block_x + 1) * side, plane.width()),
          std::min((block_y + 1) * side, plane.height())};
}

void start_mean(const Image<std::uint8_t>& plane, Image<std::int16_t>& mean) {
  mean.resize(plane.width(), plane.height());
  for (std::size_t i = 0; i < plane.view().pixel_count(); ++i) {
    mean.data()[i] = static_cast<std::int16_t>(plane.data()[i] * kScale);
  }
}

void pass(const Image<std::uint8_t>& input, const Part& part, Image<std::int16_t>& mean,
          Image<std::uint8_t>& shown) {
  for (int y = part.y0; y < part.y1; ++y) {
    const std::uint8_t* from = input.view().row(y);
    std::int16_t* means = mean.view().row(y);
    std::uint8_t* to = shown.view().row(y);
    for (int x = part.x0; x < part.x1; ++x) {
      means[x] = static_cast<std::int16_t>(from[x] * kScale);
      to[x] = from[x];
    }
  }
}

void hold(const Image<std::uint8_t>& input, const Part& part, Image<std::int16_t>& mean,
          Image<std::uint8_t>& shown) {
  for (int y = part.y0; y < part.y1; ++y) {
    const std::uint8_t* from = input.view().row(y);
    std::int16_t* means = mean.view().row(y);
    std::uint8_t* to = shown.view().row(y);
    for (int x = part.x0; x < part.x1; ++x) {
      const int refined = means[x] + ((from[x] * kScale - means[x]) >> kRefineShift);
      means[x] = static_cast<std::int16_t>(refined);
      const bool moved = std::abs(refined - to[x] * kScale) > kShownReach;
      to[x] = moved ? static_cast<std::uint8_t>((refined + kScale / 2) / kScale) : to[x];
    }
  }
}

/// How much a block differs from its mean.
struct Difference {
  int sum = 0, stray_pixels = 0;
};

Difference difference(const Image<std::uint8_t>& luma, const Image<std::int16_t>& mean,
                      const Part& part, int stray) {
  Difference found;
  for (int y = part.y0; y < part.y1; ++y) {
    const std::uint8_t* from = luma.view().row(y);
    const std::int16_t* means = mean.view().row(y);
    for (int x = part.x0; x < part.x1; ++x) {
      const int d = from[x] * kScale - means[x];
      found.sum += d;
      found.stray_pixels += std::abs(d) > stray;
    }
  }
  return found;
}

}  // namespace

I420Image& ColorHold::apply(const I420Image& input) {
  if (shown_.y.empty()) {
    begin(input);
    return shown_;
  }
  measure_noise(input.y);
  const int stray = static_cast<int>(std::lround(kPixelSigmas * sigma_ * kScale));
  const int most_sum = static_cast<int>(std::lround(kSumSigmas * sigma_ * kSide * kScale));
  const int blocks_x = (input.y.width() + kSide - 1) / kSide,
            blocks_y = (input.y.height() + kSide - 1) / kSide;
  for (int block_y = 0; block_y < blocks_y; ++block_y) {
    for (int block_x = 0; block_x < blocks_x; ++block_x) {
      const Difference found =
          difference(input.y, mean_.y, part_of(input.y, block_x, block_y, kSide), stray);
      const bool still = std::abs(found.sum) <= most_sum && found.stray_pixels <= kMostStrayPixels;
      still ? hold_block(input, block_x, block_y) : pass_block(input, block_x, block_y);
    }
  }
  return shown_;
}

void ColorHold::begin(const I420Image& input) {
  shown_ = input;
  start_mean(input.y, mean_.y);
  start_mean(input.cb, mean_.cb);
  start_mean(input.cr, mean_.cr);
}

void ColorHold::measure_noise(const Image<std::uint8_t>& luma) {
  constexpr int kRowStep = 8;
  std::array<int, 256> histogram{};
  int count = 0;
  for (int y = 0; y < luma.height(); y += kRowStep) {
    const std::uint8_t* from = luma.view().row(y);
    const std::int16_t* means = mean_.y.view().row(y);
    for (int x = 0; x < luma.width(); ++x) {
      const int quarters = std::abs(from[x] * kScale - means[x]) / (kScale / 4);
      ++histogram[static_cast<std::size_t>(std::min(quarters, 255))];
    }
    count += luma.width();
  }
  int median_quarters = 0;
  for (int seen = histogram[0]; 2 * seen < count; seen += histogram[++median_quarters]) {
  }
  const double sigma = kMadToSigma * (median_quarters + 0.5) / 4;
  sigma_ = std::clamp(sigma_ + kNoiseStep * (sigma - sigma_), kLeastSigma, kMostSigma);
}

void ColorHold::pass_block(const I420Image& input, int block_x, int block_y) {
  pass(input.y, part_of(input.y, block_x, block_y, kSide), mean_.y, shown_.y);
  const Part chroma = part_of(input.cb, block_x, block_y, kSide / 2);
  pass(input.cb, chroma, mean_.cb, shown_.cb);
  pass(input.cr, chroma, mean_.cr, shown_.cr);
}

void ColorHold::hold_block(const I420Image& input, int block_x, int block_y) {
  hold(input.y, part_of(input.y, block_x, block_y, kSide), mean_.y, shown_.y);
  const Part chroma = part_of(input.cb, block_x, block_y, kSide / 2);
  hold(input.cb, chroma, mean_.cb, shown_.cb);
  hold(input.cr, chroma, mean_.cr, shown_.cr);
}

}  // namespace roomcast::codec
