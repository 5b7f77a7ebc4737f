// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/sender/small_rendition.h"

#include <chrono>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace roomcast::sensor {
namespace {

using namespace std::chrono_literals;

constexpr int kGridWidth = 320, kGridHeight = 240;
constexpr double kSmallFps = 15, kSmallBytesPerSecond = 37'500;

codec::FrameEncoderOptions full_options(int color_scale) {
  codec::FrameEncoderOptions options;
  options.width = kGridWidth;
  options.height = kGridHeight;
  options.fps = kSmallFps;
  options.color_scale = color_scale;
  return options;
}

/// A wall with noise, before which something moves.
DepthImage small_depth_at(int frame) {
  std::minstd_rand random(static_cast<unsigned>(frame));
  DepthImage depth(kGridWidth, kGridHeight);
  for (int y = 0; y < kGridHeight; ++y) {
    for (int x = 0; x < kGridWidth; ++x) {
      const bool is_near = std::abs(x - (40 + frame * 3 % 240)) < 30;
      depth.at(x, y) = static_cast<std::uint16_t>((is_near ? 1'500 : 3'000) + random() % 8);
    }
  }
  return depth;
}

ColorImage small_color_at(int frame, int scale) {
  ColorImage color(scale * kGridWidth, scale * kGridHeight);
  for (int y = 0; y < color.height(); ++y) {
    for (int x = 0; x < color.width(); ++x)
      color.at(x, y) = {static_cast<std::uint8_t>(x + 5 * frame), static_cast<std::uint8_t>(y), 90};
  }
  return color;
}

class Scales : public testing::TestWithParam<int> {};

TEST_P(Scales, it_keeps_to_its_rate_and_every_decoder_takes_it) {
  auto small = SmallRendition::create(full_options(GetParam()), kSmallBytesPerSecond);
  ASSERT_TRUE(small.ok()) << small.error().message;
  auto decoder = codec::FrameDecoder::create(kGridWidth, kGridHeight);
  ASSERT_TRUE(decoder.ok());
  codec::DecodedFrame shown;
  constexpr int kFrames = 150;
  for (int i = 0; i < kFrames; ++i) {
    std::vector<std::uint8_t> payload;
    const DepthImage depth = small_depth_at(i);
    const ColorImage color = small_color_at(i, GetParam());
    const MaskImage seen(kGridWidth, kGridHeight, 255);
    const HostTime now(std::chrono::duration_cast<nanoseconds>(i * 1s / kSmallFps));
    const auto info = (*small)->encode(depth, color, seen, now, false, payload);
    ASSERT_TRUE(info.ok()) << info.error().message;
    EXPECT_EQ(info->has_value(), !payload.empty());
    if (!*info) continue;
    ASSERT_TRUE((*decoder)->decode(payload, shown).ok()) << i;
    EXPECT_EQ(shown.color.width(), kGridWidth) << "at most the depth grid's size";
  }
  const double seconds = kFrames / kSmallFps;
  EXPECT_LT(static_cast<double>((*small)->bytes()) / seconds, 1.1 * kSmallBytesPerSecond);
  EXPECT_GT((*small)->bytes(), 0u);
}

INSTANTIATE_TEST_SUITE_P(SmallRendition, Scales, testing::Values(1, 2));

TEST(SmallRendition, a_wanted_key_frame_comes_with_the_next_frame_that_is_sent) {
  auto small = SmallRendition::create(full_options(1), 5'000);  // so slow that frames are left out
  ASSERT_TRUE(small.ok());
  int keys = 0, left_out = 0;
  for (int i = 0; i < 60; ++i) {
    std::vector<std::uint8_t> payload;
    const HostTime now(std::chrono::duration_cast<nanoseconds>(i * 1s / kSmallFps));
    const auto info =
        (*small)->encode(small_depth_at(i), small_color_at(i, 1),
                         MaskImage(kGridWidth, kGridHeight, 255), now, i == 30, payload);
    ASSERT_TRUE(info.ok());
    if (*info)
      keys += (*info)->key;
    else
      ++left_out;
  }
  EXPECT_GT(left_out, 0);
  EXPECT_EQ(keys, 2) << "the first frame, and the wanted one";
}

TEST(SmallRendition, one_decoder_shows_both_renditions_in_turns) {
  auto full = codec::FrameEncoder::create(full_options(2));
  auto small = SmallRendition::create(full_options(2), kSmallBytesPerSecond);
  auto decoder = codec::FrameDecoder::create(kGridWidth, kGridHeight);
  ASSERT_TRUE(full.ok() && small.ok() && decoder.ok());
  const MaskImage seen(kGridWidth, kGridHeight, 255);
  codec::DecodedFrame shown;
  for (int i = 0; i < 60; ++i) {
    const bool shows_small = i / 15 % 2 == 1, begins = i % 15 == 0;
    const DepthImage depth = small_depth_at(i);
    const ColorImage color = small_color_at(i, 2);
    std::vector<std::uint8_t> of_full, of_small;
    const HostTime now(std::chrono::duration_cast<nanoseconds>(i * 1s / kSmallFps));
    ASSERT_TRUE((*full)->encode(depth, color, seen, begins && !shows_small, of_full).ok());
    ASSERT_TRUE((*small)->encode(depth, color, seen, now, begins && shows_small, of_small).ok());
    const auto& payload = shows_small ? of_small : of_full;
    if (payload.empty()) continue;
    ASSERT_TRUE((*decoder)->decode(payload, shown).ok()) << i;
    EXPECT_EQ(shown.color.width(), (shows_small ? 1 : 2) * kGridWidth) << i;
    EXPECT_NEAR(shown.depth_mm.at(kGridWidth - 10, 10), depth.at(kGridWidth - 10, 10), 60) << i;
  }
}

}  // namespace
}  // namespace roomcast::sensor
