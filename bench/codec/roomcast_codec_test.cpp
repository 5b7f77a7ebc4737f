// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/roomcast_codec.h"

#include <gtest/gtest.h>

#include "roomcast/codec/testing/synthetic_color.h"

namespace roomcast::bench {
namespace {

constexpr BenchPicture kPicture{96, 64, 30, 900};

BenchFrame frame_of(int i) {
  codec::SyntheticFrame made = codec::synthetic_frame(kPicture.width, kPicture.height, i);
  return {std::move(made.depth_mm), std::move(made.color), std::move(made.seen)};
}

TEST(RoomcastCodec, lossless_gives_back_depth_and_sends_no_colour) {
  auto codec = make_roomcast_lossless(kPicture);
  ASSERT_TRUE(codec.ok());
  const BenchFrame frame = frame_of(0);
  BenchFrame decoded;
  const auto cost = (*codec)->run(frame, true, decoded);
  ASSERT_TRUE(cost.ok());
  EXPECT_EQ(decoded.depth_mm, frame.depth_mm);
  EXPECT_TRUE(decoded.color.empty());
  EXPECT_EQ(cost->color_bytes, 0u);
  EXPECT_GT(cost->depth_bytes, 0u);
}

TEST(RoomcastCodec, live_sends_less_than_lossless_and_stays_near) {
  auto live = make_roomcast_live(kPicture);
  auto lossless = make_roomcast_lossless(kPicture);
  ASSERT_TRUE(live.ok() && lossless.ok());
  BenchFrame decoded, exact;
  const auto cost = (*live)->run(frame_of(0), true, decoded);
  ASSERT_TRUE(cost.ok());
  EXPECT_LT(cost->depth_bytes, (*lossless)->run(frame_of(0), true, exact)->depth_bytes);
  EXPECT_EQ(decoded.depth_mm.width(), kPicture.width);
}

TEST(RoomcastCodec, live_with_color_counts_depth_and_colour_apart) {
  auto codec = make_roomcast_live_with_color(kPicture);
  ASSERT_TRUE(codec.ok());
  BenchFrame decoded;
  const auto cost = (*codec)->run(frame_of(0), true, decoded);
  ASSERT_TRUE(cost.ok());
  EXPECT_GT(cost->depth_bytes, 0u);
  EXPECT_GT(cost->color_bytes, 0u);
  EXPECT_EQ(decoded.color.width(), kPicture.width);
}

TEST(RoomcastCodec, color_gives_back_colour_alone) {
  auto codec = make_roomcast_color(kPicture);
  ASSERT_TRUE(codec.ok());
  std::size_t key_bytes = 0;
  for (int i = 0; i < 3; ++i) {
    const BenchFrame frame = frame_of(i);
    BenchFrame decoded;
    const auto cost = (*codec)->run(frame, i == 0, decoded);
    ASSERT_TRUE(cost.ok());
    EXPECT_TRUE(decoded.depth_mm.empty());
    EXPECT_LT(codec::color_rms(decoded.color, frame.color, frame.seen), 25);
    if (i == 0) {
      key_bytes = cost->color_bytes;
    } else {
      EXPECT_LT(cost->color_bytes, key_bytes);
    }
  }
}

}  // namespace
}  // namespace roomcast::bench
