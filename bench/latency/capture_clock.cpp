// SPDX-License-Identifier: Apache-2.0
#include "bench/latency/capture_clock.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>

namespace roomcast::bench {
namespace {

constexpr int kBitsInRow = kClockColumns / 2;
constexpr int kMinWidth = 64, kMinHeight = 48;
/// Squares are large, so that they survive a coarse picture.
constexpr double kSquaresAcross = 16, kSquaresDown = 12;
constexpr double kMinContrast = 60;  // of 255
constexpr Rgb8 kWhite{255, 255, 255}, kBlack{0, 0, 0};

double square_side(int width, int height) {
  return std::min(width / kSquaresAcross, height / kSquaresDown);
}

bool bit_of(std::uint16_t time_ms, int column, int row) {
  return time_ms >> (row * kBitsInRow + column / 2) & 1;
}

}  // namespace

Eigen::Vector2d clock_square(int width, int height, int column, int row) {
  const double side = square_side(width, height);
  return {0.5 * (width - 1) + side * (column + 0.5 - 0.5 * kClockColumns),
          0.5 * (height - 1) + side * (row + 0.5 - 0.5 * kClockRows)};
}

std::uint16_t clock_of(HostTime captured) {
  const auto age = SteadyClock().now() - captured;
  const auto utc = std::chrono::system_clock::now() - age;
  return static_cast<std::uint16_t>(
      std::chrono::duration_cast<std::chrono::milliseconds>(utc.time_since_epoch()).count());
}

void draw_clock(std::uint16_t time_ms, ImageView<Rgb8> picture) {
  if (picture.width < kMinWidth || picture.height < kMinHeight) return;
  const double half = 0.5 * square_side(picture.width, picture.height);
  for (int row = 0; row < kClockRows; ++row) {
    for (int column = 0; column < kClockColumns; ++column) {
      const bool is_left = column % 2 == 0;
      const Rgb8 level = bit_of(time_ms, column, row) == is_left ? kWhite : kBlack;
      const Eigen::Vector2d middle = clock_square(picture.width, picture.height, column, row);
      const int left = static_cast<int>(std::ceil(middle.x() - half));
      const int top = static_cast<int>(std::ceil(middle.y() - half));
      for (int y = top; y < middle.y() + half; ++y) {
        for (int x = left; x < middle.x() + half; ++x) picture.at(x, y) = level;
      }
    }
  }
}

std::optional<std::uint16_t> read_clock(
    const std::function<double(int column, int row)>& brightness) {
  int time_ms = 0;
  for (int row = 0; row < kClockRows; ++row) {
    for (int column = 0; column < kClockColumns; column += 2) {
      const double difference = brightness(column, row) - brightness(column + 1, row);
      if (std::abs(difference) < kMinContrast) return std::nullopt;
      if (difference > 0) time_ms |= 1 << (row * kBitsInRow + column / 2);
    }
  }
  return static_cast<std::uint16_t>(time_ms);
}

int clock_ms_between(std::uint16_t earlier, std::uint16_t later) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(later - earlier));
}

}  // namespace roomcast::bench
