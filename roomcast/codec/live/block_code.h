// SPDX-License-Identifier: Apache-2.0
// One coded 8x8 block of a live depth picture: the encoder's decisions, as read by the decoder.
// docs/spec/codec.md §2.4.2.
#pragma once

#include <array>
#include <cstdint>

#include "roomcast/codec/live/block_transform.h"

namespace roomcast::codec {

enum class BlockMode : std::uint8_t {
  kSkip,    // unchanged from the reference
  kRefine,  // smooth correction added to the readings
  kLabels,  // one label per pixel gives the source of its value
  kRaw      // a value per pixel: used when no other mode stays within the bound
};

/// Source of a pixel's value.
enum class PixelLabel : std::uint8_t {
  kUnchanged,   // the reference
  kBackground,  // the stored background
  kVanished,    // the reading disappears
  kFirst,       // the block's first surface
  kSecond       // the block's second surface
};
[[nodiscard]] constexpr bool on_surface(PixelLabel label) {
  return label >= PixelLabel::kFirst;
}

/// Most halvings of the quantiser step, for surfaces with fine relief: the step is divided by 1, 2
/// or 4.
inline constexpr int kMaxFiner = 2;

struct SurfaceCode {
  std::uint8_t candidate = 0;  // index of the predicting surface
  std::uint8_t finer = 0;      // halvings of the step
  BlockCoefficients steps{};   // quantised, after subtracting the prediction
};

struct BlockCode {
  BlockMode mode = BlockMode::kSkip;
  std::uint8_t surface_count = 0;
  std::array<SurfaceCode, 2> surfaces;
  BlockCoefficients refinement{};                      // quantised
  std::array<PixelLabel, kBlockPixels> labels{};       // those outside the picture are ignored
  std::array<std::uint16_t, kBlockPixels> readings{};  // levels
};

}  // namespace roomcast::codec
