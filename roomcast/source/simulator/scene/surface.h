// SPDX-License-Identifier: Apache-2.0
// What a thing's skin looks like: a procedural pattern and its colours, evaluated at a point of the
// surface. No picture files, no repetition. Colours are linear light, 0..1; surface coordinates in
// metres.
#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace roomcast::sim {

enum class Pattern {
  kPlain,
  kPlaster,
  kPlanks,
  kWood,
  kBrick,
  kWallpaper,
  kRug,
  kFabric,
  kPlaid,
  kDenim,
  kBookSpine,
  kPainting,
  kGarden,
  kLeaf,
  kCarpetTiles,
  kScreen,
  kDrawings,
  kFace,
  kTiles,  // repeats exactly with period size_m, and is its own mirror image
  kFlat,   // paint with next to nothing to see in it
  kConcrete,
  kTerrazzo,
  kStripes,  // across, size_m.y wide
  kPoster,
  kRackFace,
  kKeys,
};

struct Surface {
  Pattern pattern = Pattern::kPlain;
  Eigen::Vector3f base = Eigen::Vector3f::Constant(0.5F);
  Eigen::Vector3f accent = Eigen::Vector3f::Constant(0.3F);
  Eigen::Vector3f trim = Eigen::Vector3f::Constant(0.1F);
  Eigen::Vector2f size_m =
      Eigen::Vector2f::Ones();  // of one picture, rug, spine: where the pattern ends
  std::uint32_t seed = 0;
  float infrared =
      0.5F;  // share of a depth camera's light that comes back; 0: it never returns a reading
  float glow = 0.0F;  // how much of the colour is the surface's own light, 0..1
};

/// 0xRRGGBB as in web pages -> linear light.
[[nodiscard]] Eigen::Vector3f linear_from_srgb(std::uint32_t rrggbb);

/// A surface from web colours; what else it has can be set afterwards.
[[nodiscard]] Surface painted(Pattern pattern, std::uint32_t base, std::uint32_t accent,
                              std::uint32_t trim, std::uint32_t seed, float infrared = 0.5F);

/// Linear light -> 0..255 sRGB values, highlights rolled off softly.
[[nodiscard]] Eigen::Vector3f srgb_from_linear(const Eigen::Vector3f& light);

/// The share of light per channel that the surface returns at `at_m`. `footprint_m`: width of what
/// the pixel sees.
[[nodiscard]] Eigen::Vector3f albedo_at(const Surface& surface, const Eigen::Vector2f& at_m,
                                        float footprint_m);

}  // namespace roomcast::sim
