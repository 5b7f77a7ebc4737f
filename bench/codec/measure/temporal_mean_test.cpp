// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/measure/temporal_mean.h"

#include <array>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

ColorImage grey(std::uint8_t value) {
  return {1, 1, {value, value, value}};
}
const MaskImage kSeenInEveryFrame(1, 1, 255), kUnseen(1, 1, 0);

std::uint8_t mean_of(std::uint8_t own, const ColorImage& before, const MaskImage& before_seen,
                     const ColorImage& after) {
  const ColorImage color = grey(own);
  const std::array<SeenColor, 2> around{{{before, before_seen}, {after, kSeenInEveryFrame}}};
  ColorImage out;
  temporal_mean({color, kSeenInEveryFrame}, around, out);
  return out.at(0, 0).g;
}

TEST(TemporalMean, takes_the_mean_of_near_colours) {
  EXPECT_EQ(mean_of(100, grey(103), kSeenInEveryFrame, grey(106)), 103);
}

TEST(TemporalMean, leaves_out_far_and_unseen_pixels) {
  EXPECT_EQ(mean_of(100, grey(111), kSeenInEveryFrame, grey(102)), 101);
  EXPECT_EQ(mean_of(100, grey(108), kUnseen, grey(102)), 101);
}

TEST(TemporalMean, is_black_where_the_frame_is_not_seen) {
  const ColorImage color = grey(100);
  ColorImage out;
  temporal_mean({color, kUnseen}, {}, out);
  EXPECT_EQ(out.at(0, 0), Rgb8{});
}

}  // namespace
}  // namespace roomcast::bench
