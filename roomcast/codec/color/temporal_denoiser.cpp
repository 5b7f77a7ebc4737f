// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/temporal_denoiser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace roomcast::codec {
namespace {

constexpr int kSide = 8;    // of a block, luma pixels
constexpr int kScale = 64;  // units of a mean per grey level
constexpr int kRefineShift = 3;
constexpr int kHalfStep = 1 << (kRefineShift - 1);
constexpr std::uint8_t kConvergedFrames = 8;  // after so many held frames the mean is accurate
// Tolerated squared difference of the shown block from the mean, square grey levels per pixel: a
// constant, and a factor of the noise variance.
constexpr double kMinGain = 1, kNoiseGain = 0.25;

// A block is still if its sum and nearly all its pixels differ from the mean by no more than noise.
constexpr double kPixelSigmas = 4, kSumSigmas = 4;
constexpr int kMaxStrayPixels = 2;
constexpr int kNoiseUnits = 4;  // of Block::noise, for each 1/kScale grey level
constexpr int kNoiseShift = 4;  // weight of the newest frame

constexpr double kMadToSigma = 1.4826;
constexpr double kNoiseStep = 0.1;
constexpr double kMinSigma = 0.5, kMaxSigma = 8;

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

void refine(const Image<std::uint8_t>& input, const Part& part, Image<std::int16_t>& mean) {
  for (int y = part.y0; y < part.y1; ++y) {
    const std::uint8_t* from = input.view().row(y);
    std::int16_t* means = mean.view().row(y);
    for (int x = part.x0; x < part.x1; ++x) {
      means[x] = static_cast<std::int16_t>(
          means[x] + ((from[x] * kScale - means[x] + kHalfStep) >> kRefineShift));
    }
  }
}

void show(const Image<std::int16_t>& mean, const Part& part, Image<std::uint8_t>& shown) {
  for (int y = part.y0; y < part.y1; ++y) {
    const std::int16_t* means = mean.view().row(y);
    std::uint8_t* to = shown.view().row(y);
    for (int x = part.x0; x < part.x1; ++x) {
      to[x] = static_cast<std::uint8_t>((means[x] + kScale / 2) / kScale);
    }
  }
}

/// Sum of the squared differences of the shown block from the mean, square grey levels.
double shown_error(const Image<std::int16_t>& mean, const Part& part,
                   const Image<std::uint8_t>& shown) {
  int squares = 0;
  for (int y = part.y0; y < part.y1; ++y) {
    const std::int16_t* means = mean.view().row(y);
    const std::uint8_t* now = shown.view().row(y);
    for (int x = part.x0; x < part.x1; ++x) {
      const int d = now[x] * kScale - means[x];
      squares += d * d / kScale;
    }
  }
  return static_cast<double>(squares) / kScale;
}

/// Difference of a block from its mean, 1/kScale grey levels.
struct Difference {
  int sum = 0, size_sum = 0, stray_pixels = 0;
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
      found.size_sum += std::abs(d);
      found.stray_pixels += std::abs(d) > stray;
    }
  }
  return found;
}

}  // namespace

I420Image& TemporalDenoiser::apply(const I420Image& input, bool reference, MaskView left_out) {
  if (shown_.y.empty()) {
    begin(input);
    return shown_;
  }
  if (was_reference_) std::fill_n(changed_.data(), changed_.view().pixel_count(), 0);
  was_reference_ = reference;
  measure_noise(input.y);
  for (int block_y = 0; block_y < blocks_.height(); ++block_y) {
    for (int block_x = 0; block_x < blocks_.width(); ++block_x) {
      const bool is_left_out =
          left_out.data != nullptr && left_out.at(block_x / 2, block_y / 2) != 0;
      if (is_still(input.y, block_x, block_y)) {
        hold_block(input, block_x, block_y, reference && !is_left_out);
      } else if (!is_left_out) {
        pass_block(input, block_x, block_y);
      }
    }
  }
  return shown_;
}

void TemporalDenoiser::begin(const I420Image& input) {
  shown_ = input;
  start_mean(input.y, mean_.y);
  start_mean(input.cb, mean_.cb);
  start_mean(input.cr, mean_.cr);
  blocks_.resize((input.y.width() + kSide - 1) / kSide, (input.y.height() + kSide - 1) / kSide);
  changed_.resize(blocks_.width(), blocks_.height(), 1);
}

bool TemporalDenoiser::is_still(const Image<std::uint8_t>& luma, int block_x, int block_y) {
  Block& block = blocks_.at(block_x, block_y);
  const Part part = part_of(luma, block_x, block_y, kSide);
  // The mean absolute value of Gaussian noise is 4/5 of its standard deviation.
  const double sigma = std::max(sigma_, 1.25 / kScale / kNoiseUnits * block.noise);
  const int stray = static_cast<int>(std::lround(kPixelSigmas * sigma * kScale));
  const Difference found = difference(luma, mean_.y, part, stray);
  const int most_sum = static_cast<int>(std::lround(kSumSigmas * sigma * kSide * kScale));
  if (std::abs(found.sum) > most_sum || found.stray_pixels > kMaxStrayPixels) return false;
  learn_noise(block, found.size_sum / ((part.x1 - part.x0) * (part.y1 - part.y0)));
  return true;
}

void TemporalDenoiser::learn_noise(Block& block, int mean_size) {
  block.noise = static_cast<std::uint16_t>(
      block.noise + ((mean_size * kNoiseUnits - block.noise) >> kNoiseShift));
}

void TemporalDenoiser::measure_noise(const Image<std::uint8_t>& luma) {
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
  sigma_ = std::clamp(sigma_ + kNoiseStep * (sigma - sigma_), kMinSigma, kMaxSigma);
}

void TemporalDenoiser::pass_block(const I420Image& input, int block_x, int block_y) {
  blocks_.at(block_x, block_y).held = 0;
  changed_.at(block_x, block_y) = 1;
  pass(input.y, part_of(input.y, block_x, block_y, kSide), mean_.y, shown_.y);
  const Part chroma = part_of(input.cb, block_x, block_y, kSide / 2);
  pass(input.cb, chroma, mean_.cb, shown_.cb);
  pass(input.cr, chroma, mean_.cr, shown_.cr);
}

void TemporalDenoiser::hold_block(const I420Image& input, int block_x, int block_y,
                                  bool reference) {
  const Part luma = part_of(input.y, block_x, block_y, kSide);
  const Part chroma = part_of(input.cb, block_x, block_y, kSide / 2);
  refine(input.y, luma, mean_.y);
  refine(input.cb, chroma, mean_.cb);
  refine(input.cr, chroma, mean_.cr);
  std::uint8_t& held = blocks_.at(block_x, block_y).held;
  held = std::min<std::uint8_t>(kConvergedFrames, held + 1);
  if (!reference || held < kConvergedFrames) return;
  const double error = shown_error(mean_.y, luma, shown_.y) +
                       shown_error(mean_.cb, chroma, shown_.cb) +
                       shown_error(mean_.cr, chroma, shown_.cr);
  if (error > kSide * kSide * (kMinGain + kNoiseGain * sigma_ * sigma_)) {
    show(mean_.y, luma, shown_.y);
    show(mean_.cb, chroma, shown_.cb);
    show(mean_.cr, chroma, shown_.cr);
    changed_.at(block_x, block_y) = 1;
  }
}

}  // namespace roomcast::codec
