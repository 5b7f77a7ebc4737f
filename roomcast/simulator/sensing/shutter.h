// SPDX-License-Identifier: Apache-2.0
// Shutter: a colour camera that exposes its rows one after the other (rolling shutter), each for a
// while (motion blur). The sensors stand still, so only what moves is bent and blurred. The light
// of a few instants is blended row by row, in linear light. Model: Meingast, Geyer, Sastry,
// "Geometric models of rolling-shutter cameras", OMNIVIS 2005. Pure functions.
#pragma once

#include <array>
#include <span>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"

namespace roomcast::simulator {

inline constexpr std::size_t kShutterInstants = 5;

struct Shutter {
  float readout_s = 0;   // from the first row to the last
  float exposure_s = 0;  // of each row

  /// False for a camera that sees the whole picture at one instant.
  [[nodiscard]] bool takes_time() const { return readout_s > 0 || exposure_s > 0; }

  /// The middles of equal slices of the time from the first row's opening to the last row's
  /// closing, relative to the middle of that time.
  [[nodiscard]] std::array<nanoseconds, kShutterInstants> instants() const;
  /// What each instant contributes to a row at this share of the picture's height; the sum is 1.
  [[nodiscard]] std::array<float, kShutterInstants> weights(float share_of_height) const;
};

/// `lights`: the pictures (sRGB levels, at gain 1) of the instants, in their order and of one size,
/// which is that of `out`.
void expose_rows(const Shutter& shutter, std::span<const ColorImage, kShutterInstants> lights,
                 ImageView<Rgb8> out);

}  // namespace roomcast::simulator
