// SPDX-License-Identifier: Apache-2.0
// Surface: the appearance of an object: a procedural pattern and its colours, evaluated at a point
// of the surface. No picture files, no repetition. Colours are linear light, 0..1; surface
// coordinates in metres.
#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace roomcast::simulator {

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
  kFlat,   // paint with almost no texture
  kConcrete,
  kTerrazzo,
  kStripes,  // horizontal, size_m.y wide
  kPoster,
  kRackFace,
  kKeys,
  kTag,  // AprilTag 36h11 number 0 with its white rim, size_m wide
};

struct Surface {
  Pattern pattern = Pattern::kPlain;
  Eigen::Vector3f base = Eigen::Vector3f::Constant(0.5F);
  Eigen::Vector3f accent = Eigen::Vector3f::Constant(0.3F);
  Eigen::Vector3f trim = Eigen::Vector3f::Constant(0.1F);
  Eigen::Vector2f size_m = Eigen::Vector2f::Ones();  // extent of one picture, rug or spine
  std::uint32_t seed = 0;
  float infrared =
      0.5F;  // share of a depth camera's light that comes back; 0: it never returns a reading
  float gloss = 0.0F;   // share of a depth camera's light that is mirrored instead of scattered
  float polish = 0.0F;  // exponent of the specular lobe; glass: some thousands
  float glow = 0.0F;    // emitted share of the colour, 0..1
};

/// 0xRRGGBB in sRGB -> linear light.
[[nodiscard]] Eigen::Vector3f linear_from_srgb(std::uint32_t rrggbb);

/// A surface from sRGB colours; other fields can be set afterwards.
[[nodiscard]] Surface painted(Pattern pattern, std::uint32_t base, std::uint32_t accent,
                              std::uint32_t trim, std::uint32_t seed, float infrared = 0.5F);

/// The surface behind glass, which mirrors 4 % (Fresnel's equations, refractive index 1.5). Colours
/// stay matt.
[[nodiscard]] Surface glazed(Surface surface);

/// Share of a depth camera's light that returns to it from a surface at this cosine of incidence,
/// relative to a matt white surface. A polished surface reflects most light away, but at normal
/// incidence returns a multiple: the emitter is next to the lens, so the half vector of Blinn's
/// lobe ("Models of light reflection for computer synthesized pictures", SIGGRAPH 1977; normalised
/// by (n + 8) / 8) is the line of sight.
[[nodiscard]] float infrared_back(const Surface& surface, float facing);

/// Linear light -> 0..255 sRGB values with soft highlight compression. The unused fourth channel
/// allows SIMD over all channels.
[[nodiscard]] Eigen::Array4f srgb_from_linear(const Eigen::Array4f& light);
[[nodiscard]] inline Eigen::Vector3f srgb_from_linear(const Eigen::Vector3f& light) {
  return srgb_from_linear(Eigen::Array4f(light.x(), light.y(), light.z(), 0.0F)).head<3>();
}

/// Reflected share of the light per channel at `at_m`. `footprint_m`: width seen by the pixel.
[[nodiscard]] Eigen::Vector3f albedo_at(const Surface& surface, const Eigen::Vector2f& at_m,
                                        float footprint_m);

}  // namespace roomcast::simulator
