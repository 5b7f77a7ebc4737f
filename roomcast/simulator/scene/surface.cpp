// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "roomcast/simulator/scene/patterns.h"

namespace roomcast::simulator {
namespace {

float linear_from_srgb_byte(std::uint32_t byte) {
  return std::pow(static_cast<float>(byte & 255U) / 255.0F, 2.2F);
}

constexpr float kBrightest = 4.0F;
constexpr std::size_t kCurveSize = 2048;  // steps of a fifth of a grey level; fits into the cache
constexpr float kCurveScale =
    static_cast<float>(kCurveSize) / 2.0F;  // 2 is the square root of kBrightest
using ToneCurve = std::array<float, kCurveSize + 1>;

/// Display values as a function of the square root of light, whose steps are perceptually even.
ToneCurve tone_curve() {
  ToneCurve curve{};
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const float root = (static_cast<float>(i) + 0.5F) / kCurveScale;
    const float light = root * root;
    const float rolled_off = light * (1.0F + 0.12F * light) / (1.0F + 0.42F * light);
    curve[i] = 255.0F * std::pow(std::min(rolled_off, 1.0F), 1.0F / 2.2F);
  }
  return curve;
}

}  // namespace

Eigen::Vector3f linear_from_srgb(std::uint32_t rrggbb) {
  return {linear_from_srgb_byte(rrggbb >> 16), linear_from_srgb_byte(rrggbb >> 8),
          linear_from_srgb_byte(rrggbb)};
}

Surface painted(Pattern pattern, std::uint32_t base, std::uint32_t accent, std::uint32_t trim,
                std::uint32_t seed, float infrared) {
  Surface surface;
  surface.pattern = pattern;
  surface.base = linear_from_srgb(base);
  surface.accent = linear_from_srgb(accent);
  surface.trim = linear_from_srgb(trim);
  surface.seed = seed;
  surface.infrared = infrared;
  return surface;
}

Surface glazed(Surface surface) {
  surface.gloss = 0.04F;
  surface.polish = 3000.0F;
  return surface;
}

float infrared_back(const Surface& surface, float facing) {
  if (surface.gloss == 0.0F) return surface.infrared;
  const float lobe = 0.125F * (surface.polish + 8.0F) * std::pow(facing, surface.polish);
  return (1.0F - surface.gloss) * surface.infrared + surface.gloss * lobe;
}

Eigen::Array4f srgb_from_linear(const Eigen::Array4f& light) {
  static const ToneCurve kCurve = tone_curve();
  const Eigen::Array4f index = light.max(0.0F).min(kBrightest).sqrt() * kCurveScale;
  const auto at = [&](int channel) { return kCurve[static_cast<std::size_t>(index[channel])]; };
  return {at(0), at(1), at(2), 0.0F};
}

Eigen::Vector3f albedo_at(const Surface& surface, const Eigen::Vector2f& at_m, float footprint_m) {
  switch (surface.pattern) {
    case Pattern::kPlain:
      return plain(surface, at_m, footprint_m);
    case Pattern::kPlaster:
      return plaster(surface, at_m, footprint_m);
    case Pattern::kPlanks:
      return planks(surface, at_m, footprint_m);
    case Pattern::kWood:
      return wood(surface, at_m, footprint_m);
    case Pattern::kBrick:
      return brick(surface, at_m, footprint_m);
    case Pattern::kWallpaper:
      return wallpaper(surface, at_m, footprint_m);
    case Pattern::kRug:
      return rug(surface, at_m, footprint_m);
    case Pattern::kFabric:
      return fabric(surface, at_m, footprint_m);
    case Pattern::kPlaid:
      return plaid(surface, at_m, footprint_m);
    case Pattern::kDenim:
      return denim(surface, at_m, footprint_m);
    case Pattern::kBookSpine:
      return book_spine(surface, at_m, footprint_m);
    case Pattern::kPainting:
      return painting(surface, at_m, footprint_m);
    case Pattern::kGarden:
      return garden(surface, at_m, footprint_m);
    case Pattern::kLeaf:
      return leaf(surface, at_m, footprint_m);
    case Pattern::kCarpetTiles:
      return carpet_tiles(surface, at_m, footprint_m);
    case Pattern::kScreen:
      return screen(surface, at_m, footprint_m);
    case Pattern::kDrawings:
      return drawings(surface, at_m, footprint_m);
    case Pattern::kFace:
      return face(surface, at_m, footprint_m);
    case Pattern::kTiles:
      return tiles(surface, at_m, footprint_m);
    case Pattern::kFlat:
      return flat_paint(surface, at_m, footprint_m);
    case Pattern::kConcrete:
      return concrete(surface, at_m, footprint_m);
    case Pattern::kTerrazzo:
      return terrazzo(surface, at_m, footprint_m);
    case Pattern::kStripes:
      return stripes(surface, at_m, footprint_m);
    case Pattern::kPoster:
      return poster(surface, at_m, footprint_m);
    case Pattern::kRackFace:
      return rack_face(surface, at_m, footprint_m);
    case Pattern::kKeys:
      return keys(surface, at_m, footprint_m);
    case Pattern::kTag:
      return tag(surface, at_m, footprint_m);
  }
  return surface.base;
}

}  // namespace roomcast::simulator
