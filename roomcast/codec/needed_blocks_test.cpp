// SPDX-License-Identifier: Apache-2.0
// Frames without the blocks that nobody needs: FrameEncoder::set_needs.
#include <algorithm>

#include <gtest/gtest.h>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/codec/testing/synthetic_color.h"
#include "roomcast/codec/testing/synthetic_motion.h"

namespace roomcast::codec {
namespace {

constexpr int kNeedWidth = 320, kNeedHeight = 240;
constexpr int kBlocksWide = need_blocks(kNeedWidth), kBlocksHigh = need_blocks(kNeedHeight);

struct NeededFrame {
  EncodedFrameInfo info;
  std::size_t bytes = 0;
  DecodedFrame decoded;
};

/// A ball that flies past, and a light that changes; decoders see every frame.
class NeededStream {
 public:
  NeededStream() {
    encoder_ =
        std::move(FrameEncoder::create({.width = kNeedWidth, .height = kNeedHeight})).value();
    decoder_ = std::move(FrameDecoder::create(kNeedWidth, kNeedHeight)).value();
    scene_.width = kNeedWidth;
    scene_.height = kNeedHeight;
  }
  [[nodiscard]] Status need(BlockNeedsView needs) { return encoder_->set_needs(needs); }
  void need_only(BlockNeed need) {
    const BlockNeeds needs(kBlocksWide, kBlocksHigh, need);
    EXPECT_TRUE(encoder_->set_needs(needs).ok());
  }
  NeededFrame next(bool want_key = false) {
    SyntheticFrame frame = synthetic_frame(kNeedWidth, kNeedHeight, 0);
    for (int y = 96; y < 144; ++y) {
      for (int x = 128; x < 192; ++x) {
        frame.color.at(x, y) = {static_cast<std::uint8_t>(40 + 5 * count_), 90, 120};
        frame.seen.at(x, y) = 255;
      }
    }
    frame.depth_mm = scene_.reading(count_++);
    std::vector<std::uint8_t> payload;
    NeededFrame next;
    next.info =
        encoder_->encode(frame.depth_mm, frame.color, frame.seen, want_key, payload).value();
    next.bytes = payload.size();
    EXPECT_TRUE(decoder_->decode(payload, decoded_).ok());
    const DepthView shown = encoder_->decoded_depth();
    for (int y = 0; y < kNeedHeight; ++y) {
      EXPECT_TRUE(
          std::equal(shown.row(y), shown.row(y) + kNeedWidth, decoded_.depth_mm.view().row(y)))
          << "encoder and decoder disagree";
    }
    next.decoded = decoded_;
    return next;
  }
  /// Share of pixels that are within 100 mm of the truth of the newest frame.
  [[nodiscard]] double true_share() const {
    const DepthImage truth = scene_.truth(count_ - 1);
    int close = 0;
    for (std::size_t i = 0; i < truth.view().pixel_count(); ++i)
      close += std::abs(truth.data()[i] - decoded_.depth_mm.data()[i]) < 100;
    return close / static_cast<double>(truth.view().pixel_count());
  }

 private:
  std::unique_ptr<FrameEncoder> encoder_;
  std::unique_ptr<FrameDecoder> decoder_;
  SyntheticMotion scene_;
  DecodedFrame decoded_;
  int count_ = 0;
};

TEST(NeededBlocks, what_nobody_needs_costs_little_and_stays_as_it_was) {
  NeededStream whole, without;
  NeededFrame before;
  for (int i = 0; i < 5; ++i) {
    whole.next();
    before = without.next();
  }
  without.need_only(BlockNeed::kNothing);
  std::size_t all_bytes = 0, left_bytes = 0;
  for (int i = 0; i < 10; ++i) {
    all_bytes += whole.next().bytes;
    const NeededFrame frame = without.next();
    left_bytes += frame.bytes;
    if (i > 0) {
      EXPECT_EQ(frame.decoded.depth_mm, before.decoded.depth_mm) << i;
    }
    before = frame;
  }
  EXPECT_LT(left_bytes, all_bytes / 3);
}

TEST(NeededBlocks, half_a_picture_goes_on_while_the_other_stands) {
  NeededStream stream;
  for (int i = 0; i < 4; ++i) stream.next();
  BlockNeeds needs(kBlocksWide, kBlocksHigh, BlockNeed::kAll);
  for (int y = 0; y < kBlocksHigh; ++y) {
    for (int x = 0; x < kBlocksWide / 2; ++x) needs.at(x, y) = BlockNeed::kNothing;
  }
  ASSERT_TRUE(stream.need(needs).ok());
  const NeededFrame first = stream.next();
  bool other_half_moves = false;
  for (int i = 0; i < 8; ++i) {
    const NeededFrame frame = stream.next();
    for (int y = 0; y < kNeedHeight; ++y) {
      const std::uint16_t *was = first.decoded.depth_mm.view().row(y),
                          *is = frame.decoded.depth_mm.view().row(y);
      ASSERT_TRUE(std::equal(was, was + kNeedWidth / 2, is)) << y;
      other_half_moves |= !std::equal(was + kNeedWidth / 2, was + kNeedWidth, is + kNeedWidth / 2);
    }
  }
  EXPECT_TRUE(other_half_moves);
}

TEST(NeededBlocks, what_is_needed_again_comes_at_once) {
  NeededStream stream;
  for (int i = 0; i < 4; ++i) stream.next();
  stream.need_only(BlockNeed::kNothing);
  for (int i = 0; i < 20; ++i) stream.next();
  EXPECT_LT(stream.true_share(), 0.9);
  ASSERT_TRUE(stream.need({}).ok());
  const NeededFrame again = stream.next();
  EXPECT_GT(stream.true_share(), 0.95);
  EXPECT_NEAR(again.decoded.color.at(160, 120).r, 40 + 5 * 24, 20);
}

TEST(NeededBlocks, base_blocks_change_with_frames_of_layer_0_only) {
  NeededStream stream;
  for (int i = 0; i < 4; ++i) stream.next();
  stream.need_only(BlockNeed::kBaseOnly);
  DecodedFrame base = stream.next().decoded;
  bool base_moves = false;
  for (int i = 0; i < 8; ++i) {
    const NeededFrame frame = stream.next();
    if (frame.info.layer == 0) {
      base_moves |= frame.decoded.depth_mm != base.depth_mm;
      base = frame.decoded;
    } else {
      EXPECT_EQ(frame.decoded.depth_mm, base.depth_mm);
      EXPECT_EQ(frame.decoded.color, base.color);
    }
  }
  EXPECT_TRUE(base_moves);
}

TEST(NeededBlocks, shape_alone_is_sent_without_its_colour) {
  NeededStream stream;
  for (int i = 0; i < 4; ++i) stream.next();
  stream.need_only(BlockNeed::kShapeOnly);
  const DecodedFrame first = stream.next().decoded;
  DecodedFrame last;
  for (int i = 0; i < 8; ++i) last = stream.next().decoded;
  EXPECT_NE(last.depth_mm, first.depth_mm);
  // It comes nearer to the colour that was left, but does not follow the light, which is 40
  // brighter.
  EXPECT_NEAR(last.color.at(160, 120).r, first.color.at(160, 120).r, 20);
}

TEST(NeededBlocks, a_key_frame_has_everything) {
  NeededStream stream;
  for (int i = 0; i < 4; ++i) stream.next();
  stream.need_only(BlockNeed::kNothing);
  for (int i = 0; i < 9; ++i) stream.next();
  EXPECT_TRUE(stream.next(true).info.key);
  EXPECT_GT(stream.true_share(), 0.9);
}

TEST(NeededBlocks, needs_of_another_size_are_refused) {
  NeededStream stream;
  EXPECT_FALSE(stream.need(BlockNeeds(kBlocksWide + 1, kBlocksHigh)).ok());
  EXPECT_FALSE(stream.need(BlockNeeds(kBlocksWide, 1)).ok());
}

TEST(NeededBlocks, exact_depth_has_everything_in_each_frame) {
  FrameEncoderOptions options{.width = kNeedWidth, .height = kNeedHeight};
  options.depth_mode = DepthMode::kLossless;
  const auto encoder = std::move(FrameEncoder::create(options)).value();
  const auto decoder = std::move(FrameDecoder::create(kNeedWidth, kNeedHeight)).value();
  ASSERT_TRUE(encoder->set_needs(BlockNeeds(kBlocksWide, kBlocksHigh)).ok());
  for (int i = 0; i < 3; ++i) {
    const SyntheticFrame frame = synthetic_frame(kNeedWidth, kNeedHeight, i);
    std::vector<std::uint8_t> payload;
    ASSERT_TRUE(encoder->encode(frame.depth_mm, frame.color, frame.seen, false, payload).ok());
    DecodedFrame decoded;
    ASSERT_TRUE(decoder->decode(payload, decoded).ok());
    EXPECT_EQ(decoded.depth_mm, frame.depth_mm);
  }
}

}  // namespace
}  // namespace roomcast::codec
