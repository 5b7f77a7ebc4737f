// SPDX-License-Identifier: Apache-2.0
// Masks of a stream: encoder and decoder together.
#include "roomcast/codec/mask/color_mask.h"

#include <random>

#include <gtest/gtest.h>

#include "roomcast/codec/payload/payload_sections.h"
#include "roomcast/codec/testing/synthetic_color.h"

namespace roomcast::codec {
namespace {

struct CodedMask {
  std::uint8_t codec = kIntraMask;
  std::vector<std::uint8_t> section;
};

CodedMask encoded_color_mask(ColorMaskEncoder& encoder, const SyntheticFrame& frame,
                             FrameRole role) {
  CodedMask coded{role.key ? kIntraMask : kMaskChange, {}};
  encoder.encode(frame.seen, frame.depth_mm, role, coded.section);
  return coded;
}

void expect_decodes(ColorMaskDecoder& decoder, const CodedMask& coded,
                    const SyntheticFrame& frame) {
  MaskImage mask(frame.seen.width(), frame.seen.height());
  const Status status = decoder.decode(coded.codec, coded.section, frame.depth_mm, mask.view());
  ASSERT_TRUE(status.ok()) << status.error().message;
  for (std::size_t i = 0; i < mask.view().pixel_count(); ++i) {
    const bool seen = frame.seen.data()[i] != 0 && frame.depth_mm.data()[i] != 0;
    ASSERT_EQ(mask.data()[i], seen ? 255 : 0);
  }
}

class ColorMaskSizes : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(ColorMaskSizes, every_mask_of_a_stream_comes_back) {
  const auto [width, height] = GetParam();
  ColorMaskEncoder encoder;
  ColorMaskDecoder decoder;
  LayerSchedule schedule(2, 5);
  std::mt19937 random(3);
  for (int i = 0; i < 12; ++i) {
    SyntheticFrame frame = synthetic_frame(width, height, i);
    for (int flips = 0; flips < 40; ++flips) {
      frame.seen.data()[random() % frame.seen.view().pixel_count()] ^= 255;
    }
    expect_decodes(decoder, encoded_color_mask(encoder, frame, schedule.next(false)), frame);
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, ColorMaskSizes,
                         testing::Values(std::pair{16, 16}, std::pair{33, 17}, std::pair{75, 51},
                                         std::pair{4096, 16}));

TEST(ColorMask, frames_of_layer_one_can_be_left_out) {
  ColorMaskEncoder encoder;
  ColorMaskDecoder decoder;
  LayerSchedule schedule(3, 100);
  for (int i = 0; i < 12; ++i) {
    const SyntheticFrame frame = synthetic_frame(75, 51, i);
    const FrameRole role = schedule.next(false);
    const CodedMask coded = encoded_color_mask(encoder, frame, role);
    if (role.layer == 0) expect_decodes(decoder, coded, frame);
  }
}

TEST(ColorMask, a_repeated_mask_is_shown_again) {
  ColorMaskEncoder encoder;
  ColorMaskDecoder decoder;
  const SyntheticFrame frame = synthetic_frame(64, 48, 0);
  expect_decodes(decoder, encoded_color_mask(encoder, frame, {true, 0}), frame);
  CodedMask again{kMaskChange, {}};
  ColorMaskEncoder::repeat(again.section);
  expect_decodes(decoder, again, frame);
}

TEST(ColorMask, a_mask_that_stays_takes_a_few_bytes) {
  ColorMaskEncoder encoder;
  const SyntheticFrame frame = synthetic_frame(320, 240, 1);
  const std::size_t key_bytes = encoded_color_mask(encoder, frame, {true, 0}).section.size();
  EXPECT_LT(encoded_color_mask(encoder, frame, {false, 0}).section.size(), 8u);
  EXPECT_GT(key_bytes, 50u);
}

TEST(ColorMask, decode_refuses_changes_to_a_mask_that_never_came) {
  ColorMaskEncoder encoder;
  const SyntheticFrame frame = synthetic_frame(32, 32, 1);
  (void)encoded_color_mask(encoder, frame, {true, 0});
  const CodedMask change = encoded_color_mask(encoder, frame, {false, 0});
  MaskImage mask(32, 32);
  EXPECT_FALSE(
      ColorMaskDecoder().decode(change.codec, change.section, frame.depth_mm, mask.view()).ok());
}

TEST(ColorMask, decode_refuses_an_illegal_first_byte_and_takes_any_bytes_after_it) {
  ColorMaskEncoder encoder;
  ColorMaskDecoder decoder;
  const SyntheticFrame frame = synthetic_frame(40, 32, 1);
  expect_decodes(decoder, encoded_color_mask(encoder, frame, {true, 0}), frame);
  MaskImage mask(40, 32);
  const std::vector<std::uint8_t> wrong = {2, 0, 0};
  EXPECT_FALSE(decoder.decode(kMaskChange, {}, frame.depth_mm, mask.view()).ok());
  EXPECT_FALSE(decoder.decode(kMaskChange, wrong, frame.depth_mm, mask.view()).ok());
  std::mt19937 random(8);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<std::uint8_t> bytes(1 + random() % 100);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    bytes[0] &= 1;
    ASSERT_TRUE(decoder.decode(kMaskChange, bytes, frame.depth_mm, mask.view()).ok());
  }
}

}  // namespace
}  // namespace roomcast::codec
