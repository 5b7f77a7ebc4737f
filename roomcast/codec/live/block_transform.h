// SPDX-License-Identifier: Apache-2.0
// Cosine transform of 8x8 blocks, of H.265 (ITU-T H.265 §8.6.4.2). The inverse is in integers and
// the same on every machine. Coefficients have the scale of an orthonormal transform: that of a
// flat block is eight times its value. docs/spec/codec.md §2.4.3.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace roomcast::codec {

inline constexpr int kBlockSide = 8;
inline constexpr int kBlockPixels = kBlockSide * kBlockSide;

using BlockCoefficients = std::array<std::int32_t, kBlockPixels>;  // row by row, low ones first
using BlockValues = std::array<std::int32_t, kBlockPixels>;        // row by row

/// Positions from low to high frequency.
extern const std::array<std::uint8_t, kBlockPixels> kZigzag;

/// Arithmetic modulo 2^32: any coefficients are legal. Only the first `rows` rows of coefficients
/// may be other than 0; the result does not depend on `rows` being tight.
void inverse_transform(const BlockCoefficients& coefficients, int rows, BlockValues& values);

/// The same, one number at a time as in the specification. For tests.
void inverse_transform_reference(const BlockCoefficients& coefficients, BlockValues& values);

/// `value` in steps of `step`; `rounding`: 0.5 rounds to the nearest one, less rather towards 0.
[[nodiscard]] inline std::int32_t quantised(float value, float step, float rounding) {
  const auto size = static_cast<std::int32_t>(std::abs(value) / step + rounding);
  return value < 0 ? -size : size;
}

/// For encoders; need not be exact.
void forward_transform(const std::array<float, kBlockPixels>& values,
                       std::array<float, kBlockPixels>& coefficients);

}  // namespace roomcast::codec
