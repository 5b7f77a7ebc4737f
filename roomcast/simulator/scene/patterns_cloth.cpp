// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "roomcast/simulator/random/value_noise.h"
#include "roomcast/simulator/scene/patterns.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

/// Stripes of one direction of a tartan: 0..1, wide and thin, without repetition for 5 periods.
float tartan(float at_m, float period_m, float footprint_m, std::uint32_t seed) {
  const float stripe = std::floor(at_m / period_m);
  const float inside = at_m / period_m - stripe;
  const auto which = static_cast<std::uint32_t>(static_cast<int>(stripe)) % 5U;
  const float wide = 0.25F + 0.25F * unit_from_hash(hash_of(seed, which));
  const float blur = std::max(0.02F, footprint_m / period_m);
  const float band = std::clamp((wide - std::abs(inside - 0.5F)) / blur, 0.0F, 1.0F);
  const float thread = std::clamp((0.04F - std::abs(inside - 0.08F)) / blur, 0.0F, 1.0F);
  return std::clamp(0.7F * band + 0.5F * thread, 0.0F, 1.0F);
}

/// Relative position in a rug: 0 at the centre, 1 at the rim.
float rim_distance(const Vector2f& centred_m, const Vector2f& size_m) {
  const Vector2f to_rim = 0.5F * size_m - centred_m.cwiseAbs();
  return 1.0F - 2.0F * std::min(to_rim.x(), to_rim.y()) / std::min(size_m.x(), size_m.y());
}

/// A flower-like ornament around a centre; the hash gives number and rotation of its petals.
float ornament(const Vector2f& p, float radius, std::uint32_t hash) {
  const float petals = 4.0F + static_cast<float>(hash % 5U);
  const float wave =
      0.7F + 0.3F * std::cos(petals * std::atan2(p.y(), p.x()) + 6.28F * unit_from_hash(hash));
  const float from_edge = radius * wave - p.norm();
  return std::clamp(from_edge / 0.01F, 0.0F, 1.0F) -
         0.8F * std::clamp((0.45F * radius * wave - p.norm()) / 0.01F, 0.0F, 1.0F);
}

float scattered_ornaments(const Vector2f& at_m, float spacing_m, std::uint32_t seed) {
  const Vector2f cell = (at_m / spacing_m).array().floor();
  const auto hash = hash_of(hash_of(seed, static_cast<std::uint32_t>(static_cast<int>(cell.x()))),
                            static_cast<std::uint32_t>(static_cast<int>(cell.y())));
  const Vector2f shift(unit_from_hash(hash), nth_unit(hash, 31U));
  const Vector2f centre = (cell + 0.35F * Vector2f::Ones() + 0.3F * shift) * spacing_m;
  const float radius = spacing_m * (0.18F + 0.14F * nth_unit(hash, 57U));
  return ornament(at_m - centre, radius, hash);
}

}  // namespace

Vector3f rug(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const Vector2f centred = at_m - 0.5F * s.size_m;
  const float pile = 1.0F + 0.25F * fractal_noise(at_m, 0.02F, 3, footprint_m, s.seed) +
                     0.10F * fractal_noise(at_m, 0.4F, 2, footprint_m, s.seed + 4U);
  const float rim = rim_distance(centred, s.size_m);
  if (rim > 0.97F) return mix(s.base, s.trim, 0.2F) * pile;
  if (rim > 0.76F) {
    const float edge_line = rim > 0.94F || rim < 0.79F ? 1.0F : 0.0F;
    const float flowers = scattered_ornaments(at_m, 0.16F, s.seed + 21U);
    return mix(mix(s.accent, s.trim, flowers), s.trim * 1.1F, edge_line) * pile;
  }
  const float medallion = ornament(centred, 0.30F * s.size_m.minCoeff(), s.seed * 7U + 3U);
  const float field = scattered_ornaments(at_m + Vector2f(0.05F, 0.11F), 0.21F, s.seed + 5U);
  return mix(mix(s.base, s.trim, 0.8F * field), s.accent, medallion) * pile;
}

Vector3f fabric(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const float weave =
      fractal_noise({at_m.x() * 0.5F, at_m.y()}, 0.008F, 2, footprint_m, s.seed) +
      fractal_noise({at_m.x(), at_m.y() * 0.5F}, 0.008F, 2, footprint_m, s.seed + 1U);
  const float worn = fractal_noise(at_m, 0.25F, 4, footprint_m, s.seed + 2U);
  return mix(s.base, s.accent, 0.25F + 0.5F * worn) * (1.0F + 0.15F * weave);
}

Vector3f plaid(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const float across = tartan(at_m.x(), 0.075F, footprint_m, s.seed);
  const float along = tartan(at_m.y(), 0.075F, footprint_m, s.seed + 1U);
  const float folds = 1.0F + 0.16F * fractal_noise(at_m, 0.10F, 4, footprint_m, s.seed + 2U);
  return mix(mix(s.base, s.accent, 0.75F * across), s.trim, 0.6F * along) * folds;
}

Vector3f stripes(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const float period = 2.0F * s.size_m.y();
  const float inside = std::abs(at_m.y() / period - std::round(at_m.y() / period));  // 0 .. 0.5
  const float blur = std::max(0.02F, footprint_m / period);
  const float band = std::clamp((0.25F - inside) / blur + 0.5F, 0.0F, 1.0F);
  const float folds = 1.0F + 0.16F * fractal_noise(at_m, 0.10F, 4, footprint_m, s.seed + 2U);
  const float weave = 1.0F + 0.12F * fractal_noise(at_m, 0.008F, 2, footprint_m, s.seed);
  return mix(s.base, s.accent, band) * (folds * weave);
}

Vector3f denim(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const float threads =
      fractal_noise({at_m.x() * 2.0F, at_m.y() * 0.5F}, 0.012F, 2, footprint_m, s.seed);
  const float washed = fractal_noise(at_m, 0.18F, 4, footprint_m, s.seed + 1U);
  const float seam = std::clamp((0.006F - std::abs(at_m.x())) / 0.003F, 0.0F, 1.0F);
  const Vector3f cloth = mix(s.base, s.accent, 0.35F + 0.55F * washed) * (1.0F + 0.2F * threads);
  return mix(cloth, s.trim, 0.7F * seam);
}

}  // namespace roomcast::simulator
