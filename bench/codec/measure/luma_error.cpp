// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/measure/luma_error.h"

#include <cmath>

namespace roomcast::bench {
namespace {

double luma(Rgb8 c) {
  return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

}  // namespace

void LumaError::add(ColorView decoded, ColorView reference, MaskView seen) {
  for (int y = 0; y < seen.height; ++y) {
    for (int x = 0; x < seen.width; ++x) {
      if (!seen.at(x, y)) continue;
      const double error = luma(decoded.at(x, y)) - luma(reference.at(x, y));
      squares_ += error * error;
      ++count_;
    }
  }
}

void LumaError::add(const LumaError& other) {
  squares_ += other.squares_;
  count_ += other.count_;
}

std::optional<double> LumaError::psnr_db() const {
  if (squares_ == 0) return std::nullopt;
  return 10 * std::log10(255.0 * 255.0 * static_cast<double>(count_) / squares_);
}

}  // namespace roomcast::bench
