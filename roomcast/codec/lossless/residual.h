// SPDX-License-Identifier: Apache-2.0
// Residual of a pixel from its prediction, and back: exact, or within a bound. The bounded form is
// the uniform quantiser of near-lossless JPEG-LS (Weinberger, Seroussi, Sapiro 2000, section V):
// the prediction's error is rounded to steps of 2 * bound + 1, and later pixels are predicted from
// decoded values, so errors do not accumulate. docs/spec/codec.md §2.3.
#pragma once

#include <algorithm>
#include <cstdint>

namespace roomcast::codec {

inline constexpr int kMaxBound_mm = 63;

/// Modulo 65536: every difference fits 16 bits.
struct ExactResidual {
  [[nodiscard]] static std::int16_t error(int value, int prediction) {
    return static_cast<std::int16_t>(value - prediction);
  }
  [[nodiscard]] static std::uint16_t value(int prediction, int error) {
    return static_cast<std::uint16_t>(prediction + error);
  }
};

/// For readings only: a decoded value never becomes 0.
class BoundedResidual {
 public:
  /// `bound` 1..kMaxBound_mm.
  explicit BoundedResidual(int bound)
      : bound_(bound),
        step_(2 * bound + 1),
        reciprocal_((kOne + static_cast<std::uint64_t>(step_) - 1) /
                    static_cast<std::uint64_t>(step_)) {}

  [[nodiscard]] std::int16_t error(int value, int prediction) const {
    const int difference = value - limited(prediction);
    const int steps = divided(static_cast<std::uint32_t>(std::abs(difference) + bound_));
    return static_cast<std::int16_t>(difference < 0 ? -steps : steps);
  }
  [[nodiscard]] std::uint16_t value(int prediction, int error) const {
    return static_cast<std::uint16_t>(limited(limited(prediction) + error * step_));
  }

 private:
  static constexpr std::uint64_t kOne = 1 << 24;

  static int limited(int value) { return std::clamp(value, 1, 65535); }
  /// Divides by the step; exact for n < 2^17, because the step is below 2^7.
  [[nodiscard]] int divided(std::uint32_t n) const {
    return static_cast<int>(n * reciprocal_ / kOne);
  }

  int bound_, step_;
  std::uint64_t reciprocal_;
};

}  // namespace roomcast::codec
