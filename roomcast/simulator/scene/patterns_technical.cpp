// SPDX-License-Identifier: Apache-2.0
// Floors and equipment of workplaces: tiles, concrete, racks, keyboards; and paint with almost no
// texture.
#include <algorithm>
#include <array>
#include <cmath>

#include "roomcast/simulator/random/value_noise.h"
#include "roomcast/simulator/scene/patterns.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

std::uint32_t hash_of_cell(const Vector2f& cell, std::uint32_t seed) {
  return hash_of(hash_of(seed, static_cast<std::uint32_t>(static_cast<int>(cell.x()))),
                 static_cast<std::uint32_t>(static_cast<int>(cell.y())));
}

/// 0..1 across an edge at 0 of width `blur`.
float step(float beyond, float blur) {
  return std::clamp(beyond / blur + 0.5F, 0.0F, 1.0F);
}

}  // namespace

Vector3f tiles(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const Vector2f turns = at_m.cwiseQuotient(s.size_m);
  const Vector2f inside = (turns.array() - turns.array().floor()).matrix();
  const Vector2f from_middle = (inside.array() - 0.5F).abs().matrix();  // mirrored: 0 .. 0.5
  const float blur = std::max(0.012F, footprint_m / s.size_m.minCoeff());
  const float fade = std::min(1.0F, 0.35F / blur);  // distant tiles fade to their mean
  const float sum = from_middle.x() + from_middle.y();
  float motif = 0.0F;
  switch (s.seed % 3U) {
    case 0:  // a diamond with a hole
      motif = step(0.36F - sum, blur) - step(0.16F - sum, blur);
      break;
    case 1:  // quarter discs in the corners
      motif = step(0.30F - (Vector2f(0.5F, 0.5F) - from_middle).norm(), blur);
      break;
    default:  // a cross
      motif =
          step(0.07F - from_middle.minCoeff(), blur) * step(0.34F - from_middle.maxCoeff(), blur);
  }
  const float grout =
      step(from_middle.maxCoeff() - 0.488F, blur) * std::min(1.0F, 0.03F / blur + 0.1F);
  return mix(mix(s.base, s.accent, fade * motif + (1.0F - fade) * 0.25F), s.trim, grout);
}

Vector3f flat_paint(const Surface& s, const Vector2f& at_m, float footprint_m) {
  return s.base * (1.0F + 0.012F * fractal_noise(at_m, 1.6F, 2, footprint_m, s.seed));
}

Vector3f concrete(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const float clouds = fractal_noise(at_m, 0.8F, 4, footprint_m, s.seed);
  const float grit = fractal_noise(at_m, 0.02F, 3, footprint_m, s.seed + 1U);
  const float pores = fractal_noise(at_m, 0.05F, 2, footprint_m, s.seed + 2U);
  const Vector3f color = mix(s.base, s.accent, 0.5F + 0.6F * clouds) * (1.0F + 0.12F * grit);
  return mix(color, s.trim, std::clamp(2.5F * (pores - 0.62F), 0.0F, 0.5F));
}

Vector3f terrazzo(const Surface& s, const Vector2f& at_m, float footprint_m) {
  constexpr float kChip_m = 0.035F;
  const Vector2f cell = (at_m / kChip_m).array().floor();
  float nearest = 1.0F;
  std::uint32_t chip = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const Vector2f other = cell + Vector2f(static_cast<float>(dx), static_cast<float>(dy));
      const auto hash = hash_of_cell(other, s.seed);
      const Vector2f centre =
          (other + Vector2f(unit_from_hash(hash), nth_unit(hash, 1U))) * kChip_m;
      const float size = 0.25F + 0.5F * nth_unit(hash, 2U);
      const float away = (at_m - centre).norm() / (kChip_m * size);
      if (away < nearest) {
        nearest = away;
        chip = hash;
      }
    }
  }
  const float blur = std::max(0.15F, 2.0F * footprint_m / kChip_m);
  const float fade = std::min(1.0F, 0.5F / blur);
  const Vector3f stone = mix(s.accent, s.trim, nth_unit(chip, 3U));
  return mix(s.base, stone, fade * std::clamp((0.75F - nearest) / blur, 0.0F, 1.0F));
}

Vector3f rack_face(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const Vector2f port_m(0.016F, 0.0148F);
  const Vector2f cell = at_m.cwiseQuotient(port_m).array().floor();
  const Vector2f inside = at_m.cwiseQuotient(port_m) - cell;
  const float rim = std::min({inside.x(), 1.0F - inside.x(), inside.y(), 1.0F - inside.y()});
  const float blur = std::max(0.08F, footprint_m / port_m.y());
  const float fade = std::min(1.0F, 0.6F / blur);
  const auto block = hash_of_cell((cell / 6.0F).array().floor().matrix(), s.seed);
  const auto hash = hash_of_cell(cell, s.seed + 1U);
  const float hole = fade * step(rim - 0.18F, blur);
  const float edge = std::min(at_m.y(), s.size_m.y() - at_m.y());
  if (edge < 0.006F || at_m.x() < 0.02F || at_m.x() > s.size_m.x() - 0.02F) return s.base * 1.15F;
  if (block % 3U == 0U) return mix(s.base, s.accent, 0.15F + 0.5F * hole);  // a grille
  if (block % 3U == 1U) {  // ports, some with an indicator light
    const Vector3f light =
        (hash & 1U) != 0U ? Vector3f(0.1F, 0.7F, 0.2F) : Vector3f(0.8F, 0.45F, 0.1F);
    const Vector3f port = mix(s.base, s.trim, hole);
    return hash % 5U == 0U ? mix(port, light, 0.9F * hole) : port;
  }
  return s.base * (1.0F + 0.1F * fractal_noise(at_m, 0.05F, 2, footprint_m, s.seed));
}

/// Rows from the top, one bit per cell, the leftmost is the most significant; 1: white.
constexpr std::array<unsigned, 10> kTagRows = {0x3ff, 0x201, 0x2d5, 0x275, 0x261,
                                               0x2a1, 0x259, 0x211, 0x201, 0x3ff};

Vector3f tag(const Surface& s, const Vector2f& at_m, float footprint_m) {
  constexpr int kCells = static_cast<int>(kTagRows.size()), kSamples = 3;
  int white = 0;
  for (int i = 0; i < kSamples * kSamples; ++i) {
    const Vector2f off(static_cast<float>(i % kSamples - 1), static_cast<float>(i / kSamples - 1));
    const Vector2f cell =
        (at_m + off * footprint_m / kSamples).cwiseQuotient(s.size_m) * static_cast<float>(kCells);
    const int column = static_cast<int>(std::floor(cell.x()));
    const int row = kCells - 1 - static_cast<int>(std::floor(cell.y()));
    const bool outside = column < 0 || row < 0 || column >= kCells || row >= kCells;
    white +=
        outside || ((kTagRows[static_cast<std::size_t>(row)] >> (kCells - 1 - column)) & 1U) != 0U;
  }
  return mix(s.accent, s.base, static_cast<float>(white) / (kSamples * kSamples));
}

Vector3f keys(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const Vector2f key_m(0.019F, 0.019F);
  const float row = std::floor(at_m.y() / key_m.y());
  const Vector2f shifted(at_m.x() + 0.25F * key_m.x() * row, at_m.y());
  const Vector2f cell = shifted.cwiseQuotient(key_m).array().floor();
  const Vector2f inside = shifted.cwiseQuotient(key_m) - cell;
  const float rim = std::min({inside.x(), 1.0F - inside.x(), inside.y(), 1.0F - inside.y()});
  const float blur = std::max(0.08F, footprint_m / key_m.x());
  const float top = std::min(1.0F, 0.6F / blur) * step(rim - 0.12F, blur);
  const Vector2f off = (inside.array() - 0.45F).abs();
  const bool letter = off.x() < 0.12F && off.y() < 0.18F && hash_of_cell(cell, s.seed) % 3U != 0U;
  return mix(s.base, letter && blur < 0.3F ? s.trim : s.accent, top);
}

}  // namespace roomcast::simulator
