// SPDX-License-Identifier: Apache-2.0
// The scale of live depth: eight levels per standard deviation of the sensor's noise, which grows
// with distance. A quantisation step is then the same multiple of the noise at every distance (a
// variance-stabilising transform, Anscombe 1948). Integers only, so that every machine builds the
// same tables. docs/spec/codec.md §2.4.1.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace roomcast::codec {

inline constexpr int kLevelsPerSigma = 8;
inline constexpr int kSigmaKnotCount = 33;
inline constexpr int kMaxLevel = 65535;

/// Noise at the distances sigma_knot_mm(0..32), as coded: see sigma_of_code.
using SigmaCodes = std::array<std::uint8_t, kSigmaKnotCount>;

/// Distance of a knot: four per octave from 256 mm to 65536 mm.
[[nodiscard]] constexpr int sigma_knot_mm(int knot) {
  return (4 + knot % 4) << (6 + knot / 4);
}

/// The largest knot not above `depth_mm`; readings nearer than the first knot count as the first.
[[nodiscard]] constexpr int sigma_knot_of(int depth_mm) {
  if (depth_mm < sigma_knot_mm(0)) return 0;
  const int octave = static_cast<int>(std::bit_width(static_cast<unsigned>(depth_mm))) - 9;
  return 4 * octave + ((depth_mm >> (octave + 6)) & 3);
}

/// Standard deviation in 1/256 mm, from 1/16 mm to 3968 mm.
[[nodiscard]] constexpr std::uint32_t sigma_of_code(std::uint8_t code) {
  return (16u + code % 16) << (code / 16);
}
/// The code whose sigma is nearest.
[[nodiscard]] std::uint8_t code_of_sigma(double sigma_mm);

/// Tables from millimetres to levels and back. 0 is no reading in both.
class DepthDomain {
 public:
  DepthDomain();
  /// Does nothing if the codes are unchanged.
  void set(const SigmaCodes& codes);

  [[nodiscard]] const SigmaCodes& codes() const { return codes_; }
  [[nodiscard]] std::uint16_t level_of(std::uint16_t depth_mm) const {
    return level_of_mm_[depth_mm];
  }
  [[nodiscard]] std::uint16_t mm_of(std::uint16_t level) const { return mm_of_level_[level]; }
  [[nodiscard]] const std::uint16_t* level_table() const { return level_of_mm_.data(); }
  [[nodiscard]] const std::uint16_t* mm_table() const { return mm_of_level_.data(); }

 private:
  void build();
  SigmaCodes codes_{};
  std::vector<std::uint16_t> level_of_mm_, mm_of_level_;
};

}  // namespace roomcast::codec
