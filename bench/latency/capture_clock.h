// SPDX-License-Identifier: Apache-2.0
// The time of capture as a code of black and white squares in a sensor's picture, to measure how
// old what a viewer sees is: the squares go through the codec, the network and the drawing like
// everything else. Four rows of four bits; each bit is two squares beside each other, of which the
// left one is white for 1 and the right one for 0. The first bit is the lowest. Pure.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include <Eigen/Core>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"

namespace roomcast::bench {

inline constexpr int kClockColumns = 8, kClockRows = 4;

/// The middle of a square in a picture of this size, pixels; the code is in the picture's middle.
[[nodiscard]] Eigen::Vector2d clock_square(int width, int height, int column, int row);

/// Milliseconds of UTC, modulo 65 536: all programs of one computer have the same.
[[nodiscard]] std::uint16_t clock_of(HostTime captured);

/// Draws the code into a picture; a smaller one than 64 x 48 pixels stays as it is.
void draw_clock(std::uint16_t time_ms, ImageView<Rgb8> picture);

/// The time that is shown, by the brightness of each square, 0 to 255. Nothing: a pair of squares
/// differs too little, because the code is hidden, blurred, or mixed from two pictures.
[[nodiscard]] std::optional<std::uint16_t> read_clock(
    const std::function<double(int column, int row)>& brightness);

/// From one time to a later one, at most half a minute.
[[nodiscard]] int clock_ms_between(std::uint16_t earlier, std::uint16_t later);

}  // namespace roomcast::bench
