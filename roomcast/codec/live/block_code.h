// SPDX-License-Identifier: Apache-2.0
// One 8x8 block of a live depth picture, as coded: what the encoder decides and
// the decoder reads. docs/spec/codec.md, "Blocks".
#pragma once

#include <array>
#include <cstdint>

#include "roomcast/codec/live/block_transform.h"

namespace roomcast::codec {

enum class BlockMode : std::uint8_t {
  kSkip,    // stays as it is in the reference
  kRefine,  // readings move by a smooth amount
  kLabels,  // each pixel says where its value comes from
  kRaw      // each pixel's own value: when nothing else keeps the bound
};

/// Where a pixel's value comes from.
enum class PixelLabel : std::uint8_t {
  kUnchanged,   // the reference
  kBackground,  // the background memory
  kVanished,    // no reading any more
  kFirst,       // the block's first surface
  kSecond       // the block's second surface
};
[[nodiscard]] constexpr bool on_surface(PixelLabel label) {
  return label >= PixelLabel::kFirst;
}

/// Divides the quantiser step of surfaces with fine relief: 1, 2 or 4.
inline constexpr int kMaxFiner = 2;

struct SurfaceCode {
  std::uint8_t candidate = 0;  // which neighbour predicts it
  std::uint8_t finer = 0;      // halvings of the step
  BlockCoefficients steps{};   // quantised, prediction taken off
};

struct BlockCode {
  BlockMode mode = BlockMode::kSkip;
  std::uint8_t surface_count = 0;
  std::array<SurfaceCode, 2> surfaces;
  BlockCoefficients refinement{};                      // quantised
  std::array<PixelLabel, kBlockPixels> labels{};       // those outside of the picture do not matter
  std::array<std::uint16_t, kBlockPixels> readings{};  // levels
};

}  // namespace roomcast::codec
