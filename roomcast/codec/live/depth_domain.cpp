// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/depth_domain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace roomcast::codec {
namespace {

constexpr int kValueCount = 65536;
constexpr std::uint64_t kOneLevel = 1u << 16;
constexpr std::uint64_t kSteepness = std::uint64_t{kLevelsPerSigma * 256} * kOneLevel;

/// Standard deviation in 1/256 mm; linear between knots.
std::uint32_t sigma_at(const SigmaCodes& codes, int depth_mm, int& knot) {
  if (depth_mm < sigma_knot_mm(0)) return sigma_of_code(codes[0]);
  while (knot + 2 < kSigmaKnotCount && depth_mm >= sigma_knot_mm(knot + 1)) ++knot;
  const int begin = sigma_knot_mm(knot), length = sigma_knot_mm(knot + 1) - begin;
  const auto from = static_cast<std::int64_t>(sigma_of_code(codes[static_cast<std::size_t>(knot)]));
  const auto to =
      static_cast<std::int64_t>(sigma_of_code(codes[static_cast<std::size_t>(knot) + 1]));
  return static_cast<std::uint32_t>(
      (from * (length - (depth_mm - begin)) + to * (depth_mm - begin)) / length);
}

}  // namespace

std::uint8_t code_of_sigma(double sigma_mm) {
  std::uint8_t best = 0;
  for (int code = 1; code < 256; ++code) {
    const auto candidate = static_cast<std::uint8_t>(code);
    if (std::abs(sigma_of_code(candidate) / 256.0 - sigma_mm) <
        std::abs(sigma_of_code(best) / 256.0 - sigma_mm)) {
      best = candidate;
    }
  }
  return best;
}

DepthDomain::DepthDomain() : level_of_mm_(kValueCount), mm_of_level_(kValueCount) {
  build();
}

void DepthDomain::set(const SigmaCodes& codes) {
  if (codes == codes_) return;
  codes_ = codes;
  build();
}

// Position P(z) = sum over millimetres below z of 8 / sigma, in 1/65536 levels. Level v represents
// the z whose position is nearest to v - 1, and vice versa.
void DepthDomain::build() {
  level_of_mm_[0] = mm_of_level_[0] = 0;
  std::uint64_t position = 0;
  int knot = 0;
  std::uint32_t next_level = 1;
  for (int z = 1; z < kValueCount; ++z) {
    const std::uint64_t step = kSteepness / sigma_at(codes_, z, knot);
    const std::uint64_t level = 1 + (position + kOneLevel / 2) / kOneLevel;
    level_of_mm_[static_cast<std::size_t>(z)] =
        static_cast<std::uint16_t>(std::min<std::uint64_t>(level, kMaxLevel));
    const std::uint64_t half_way = position + step / 2;
    for (; next_level <= kMaxLevel && (next_level - 1) * kOneLevel <= half_way; ++next_level) {
      mm_of_level_[next_level] = static_cast<std::uint16_t>(z);
    }
    position += step;
  }
  for (; next_level <= kMaxLevel; ++next_level) mm_of_level_[next_level] = kValueCount - 1;
}

}  // namespace roomcast::codec
