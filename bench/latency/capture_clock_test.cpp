// SPDX-License-Identifier: Apache-2.0
#include "bench/latency/capture_clock.h"

#include <chrono>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

std::optional<std::uint16_t> read_from(const ColorImage& picture) {
  return read_clock([&](int column, int row) {
    const Eigen::Vector2d at = clock_square(picture.width(), picture.height(), column, row);
    return static_cast<double>(
        picture.at(static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))).g);
  });
}

TEST(CaptureClock, every_time_is_read_as_it_was_drawn) {
  for (const auto& [width, height] : {std::pair{512, 424}, {640, 576}, {320, 288}, {64, 48}}) {
    for (const int time_ms : {0, 1, 0x8000, 0x5a3c, 0xffff}) {
      ColorImage picture(width, height, Rgb8{90, 90, 90});
      draw_clock(static_cast<std::uint16_t>(time_ms), picture.view());
      EXPECT_EQ(read_from(picture), time_ms) << width;
      EXPECT_EQ(picture.at(0, 0), (Rgb8{90, 90, 90})) << "only in the middle";
    }
  }
}

TEST(CaptureClock, nothing_is_read_where_nothing_or_two_times_are_drawn) {
  ColorImage picture(512, 424, Rgb8{90, 90, 90});
  EXPECT_EQ(read_from(picture), std::nullopt);
  ColorImage other = picture;
  draw_clock(0x1234, picture.view());
  draw_clock(0x1235, other.view());
  for (std::size_t i = 0; i < picture.view().pixel_count(); ++i)
    picture.data()[i].g = static_cast<std::uint8_t>((picture.data()[i].g + other.data()[i].g) / 2);
  EXPECT_EQ(read_from(picture), std::nullopt);
}

TEST(CaptureClock, a_tiny_picture_stays_as_it_is) {
  ColorImage tiny(20, 20);
  draw_clock(7, tiny.view());
  EXPECT_EQ(tiny, ColorImage(20, 20));
}

TEST(CaptureClock, times_pass_over_the_end) {
  EXPECT_EQ(clock_ms_between(65'530, 10), 16);
  EXPECT_EQ(clock_ms_between(10, 65'530), -16);
}

TEST(CaptureClock, a_capture_of_a_moment_ago_has_an_earlier_time) {
  const HostTime now = SteadyClock().now();
  const int ms = clock_ms_between(clock_of(now - std::chrono::milliseconds(500)), clock_of(now));
  EXPECT_NEAR(ms, 500, 100);
}

}  // namespace
}  // namespace roomcast::bench
