// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "roomcast/simulator/random/value_noise.h"
#include "roomcast/simulator/scene/patterns.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

/// A saturated colour of the given hue, 0..1 around the colour wheel.
Vector3f hue(float turn) {
  const Vector3f phase(0.0F, 0.33F, 0.67F);
  const Vector3f wave = ((phase.array() + turn) * 6.2832F).cos();
  return (0.5F + 0.45F * wave.array()).square();
}

float disc(const Vector2f& p, const Vector2f& centre, float radius) {
  return std::clamp((radius - (p - centre).norm()) / 0.012F, 0.0F, 1.0F);
}

/// Several ranges of hills under a sky with a sun. `p` is 0..1 in the picture, y up.
Vector3f landscape(const Surface& s, const Vector2f& p, float footprint) {
  Vector3f color = mix(linear_from_srgb(0xf2d3a8), linear_from_srgb(0x5f8fc4), p.y() * 1.2F - 0.2F);
  const float clouds = fractal_noise({p.x(), p.y() * 2.5F}, 0.4F, 4, footprint, s.seed);
  color = mix(color, Vector3f::Constant(0.9F), 1.6F * clouds);
  const Vector2f sun(0.2F + 0.6F * unit_from_hash(hash_of(s.seed, 1U)), 0.72F);
  color = mix(color, linear_from_srgb(0xfff0c0), disc(p, sun, 0.07F));
  for (std::uint32_t ridge = 0; ridge < 4U; ++ridge) {
    const float level = 0.62F - 0.14F * static_cast<float>(ridge);
    const float top =
        level + 0.12F * fractal_noise({p.x(), 0.0F}, 0.45F, 5, 0.0F, s.seed + 40U + ridge);
    const Vector3f hill = mix(s.base, s.accent, static_cast<float>(ridge) / 3.0F);
    const float rough = 1.0F + 0.6F * fractal_noise(p, 0.08F, 4, footprint, s.seed + ridge);
    color = mix(color, hill * rough, (top - p.y()) / 0.006F);
  }
  return color;
}

/// Overlapping discs and bars on a background.
Vector3f abstract(const Surface& s, const Vector2f& p, float footprint) {
  Vector3f color = s.base * (1.0F + 0.3F * fractal_noise(p, 0.3F, 5, footprint, s.seed));
  for (std::uint32_t i = 0; i < 14U; ++i) {
    const auto hash = hash_of(s.seed, i + 100U);
    const Vector2f centre(unit_from_hash(hash), nth_unit(hash, 3U));
    const float size = 0.04F + 0.16F * nth_unit(hash, 7U);
    const float angle = 3.14F * nth_unit(hash, 11U);
    const Vector2f across(-std::sin(angle), std::cos(angle));
    const float bar = std::clamp((0.02F - std::abs(across.dot(p - centre))) / 0.008F, 0.0F, 1.0F);
    const float inside =
        (i % 3U == 0U) ? bar * disc(p, centre, 2.0F * size) : disc(p, centre, size);
    color = mix(color, hue(nth_unit(hash, 13U)), 0.85F * inside);
  }
  return color * (1.0F + 0.12F * fractal_noise(p, 0.02F, 3, footprint, s.seed + 6U));
}

/// 1 on strokes that resemble handwriting, in lines of the given height.
float handwriting(const Vector2f& at_m, float line_m, float footprint_m, std::uint32_t seed) {
  const float line = std::floor(at_m.y() / line_m);
  const auto line_seed = hash_of(seed, static_cast<std::uint32_t>(static_cast<int>(line)));
  const float inside = at_m.y() / line_m - line - 0.5F;
  const float stroke = 0.55F * value_noise({at_m.x() / (line_m * 0.22F), 0.5F}, line_seed);
  const float word = value_noise({at_m.x() / (line_m * 1.4F), 0.5F}, line_seed + 1U);
  const float blur = 0.12F + footprint_m / line_m;
  const float ink = std::clamp((0.22F - std::abs(inside - 0.6F * stroke)) / blur, 0.0F, 1.0F);
  return word > -0.35F ? ink * std::min(1.0F, 0.25F / blur) : 0.0F;
}

}  // namespace

Vector3f book_spine(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const float up = at_m.y() / s.size_m.y();
  const auto style = s.seed % 3U;
  Vector3f color = s.base * (1.0F + 0.15F * fractal_noise(at_m, 0.03F, 3, footprint_m, s.seed));
  const bool label = style == 0U ? up > 0.55F && up < 0.85F : up > 0.30F && up < 0.80F;
  if (label && style != 2U) color = mix(color, s.accent, 0.7F);
  const Vector2f along(at_m.y(), at_m.x());
  if (label)
    color = mix(color, s.trim, 0.9F * handwriting(along, s.size_m.x(), footprint_m, s.seed));
  const bool band = std::abs(up - 0.12F) < 0.02F || std::abs(up - 0.92F) < 0.015F;
  return band ? s.accent : color;
}

Vector3f painting(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const Vector2f p = at_m.cwiseQuotient(s.size_m);
  const float footprint = footprint_m / s.size_m.y();
  const float strokes = fractal_noise(at_m, 0.012F, 2, footprint_m, s.seed + 77U);
  const Vector3f color = s.seed % 2U == 0U ? landscape(s, p, footprint) : abstract(s, p, footprint);
  return (color * (1.0F + 0.12F * strokes)).cwiseMax(0.0F).cwiseMin(1.0F);
}

Vector3f garden(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const Vector2f p = at_m.cwiseQuotient(s.size_m);
  const Vector3f sky = mix(linear_from_srgb(0xe8f0f4), linear_from_srgb(0x8fb8e0), p.y());
  const float leaves = fractal_noise(at_m, 0.35F, 5, footprint_m, s.seed);
  const float hedge = (0.42F + 0.22F * leaves - p.y()) / 0.03F;
  const Vector3f green =
      mix(s.base, s.accent, 0.5F + 0.9F * fractal_noise(at_m, 0.12F, 4, footprint_m, s.seed + 1U));
  return mix(sky, green, hedge);
}

Vector3f leaf(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const float rib = std::clamp((0.003F - std::abs(at_m.x())) / 0.002F, 0.0F, 1.0F);
  const float veins = std::sin((at_m.y() + std::abs(at_m.x())) * 260.0F);
  const float patches = fractal_noise(at_m, 0.05F, 3, footprint_m, s.seed);
  const float fine = footprint_m < 0.01F ? 0.12F * veins : 0.0F;
  return mix(mix(s.base, s.accent, 0.4F + 0.6F * patches + fine), s.trim, 0.5F * rib);
}

Vector3f screen(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const Vector2f p = at_m.cwiseQuotient(s.size_m);
  if (p.y() < 0.06F) return s.trim;
  const bool side_bar = p.x() < 0.22F;
  const Vector3f paper = side_bar ? mix(s.base, s.accent, 0.5F) : s.base;
  const float text = handwriting({at_m.x(), at_m.y()}, 0.014F, footprint_m, s.seed);
  const Vector2f picture(0.7F, 0.65F);
  const Vector2f off = (p - picture).cwiseAbs();
  if (off.x() < 0.22F && off.y() < 0.22F)
    return landscape(s, (p - picture) / 0.44F + Vector2f(0.5F, 0.5F), 0.02F);
  return mix(paper, s.accent, text);
}

Vector3f drawings(const Surface& s, const Vector2f& at_m, float footprint_m) {
  Vector3f color = s.base * (1.0F + 0.04F * fractal_noise(at_m, 0.3F, 4, footprint_m, s.seed));
  const float words = handwriting(at_m, 0.09F, footprint_m, s.seed);
  const float here = fractal_noise(at_m, 0.7F, 2, 0.0F, s.seed + 1U);
  if (here > 0.0F) color = mix(color, s.accent, 0.85F * words);
  for (std::uint32_t i = 0; i < 7U; ++i) {
    const auto hash = hash_of(s.seed, i + 7U);
    const Vector2f centre(unit_from_hash(hash) * s.size_m.x(), nth_unit(hash, 5U) * s.size_m.y());
    const float radius = 0.05F + 0.12F * nth_unit(hash, 9U);
    const float from_line = std::abs((at_m - centre).norm() - radius);
    const float blur = std::max(0.004F, footprint_m);
    color = mix(color, i % 2U == 0U ? s.trim : hue(nth_unit(hash, 1U)) * 0.6F,
                std::clamp((0.008F - from_line) / blur, 0.0F, 0.9F));
  }
  return color;
}

Vector3f poster(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const Vector2f p = at_m.cwiseQuotient(s.size_m);
  const float margin = 0.06F;
  if (p.x() < margin || p.x() > 1.0F - margin || p.y() < margin * 0.7F) return s.base;
  if (p.y() > 0.86F) {
    const float title = handwriting(at_m, 0.10F * s.size_m.y(), footprint_m, s.seed + 5U);
    return p.y() > 0.96F ? s.base : mix(s.base, s.trim, title);
  }
  if (p.y() > 0.34F) {
    const Vector2f inner((p.x() - margin) / (1.0F - 2.0F * margin), (p.y() - 0.34F) / 0.52F);
    const float footprint = footprint_m / (0.52F * s.size_m.y());
    return s.seed % 2U == 0U ? landscape(s, inner, footprint) : abstract(s, inner, footprint);
  }
  const float words = handwriting(at_m, 0.035F * s.size_m.y(), footprint_m, s.seed + 9U);
  return mix(s.base, s.trim, p.y() < 0.30F ? words : 0.0F);
}

}  // namespace roomcast::simulator
