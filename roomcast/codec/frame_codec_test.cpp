// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/frame_codec.h"

#include <random>

#include <gtest/gtest.h>

#include "roomcast/codec/payload/payload_sections.h"
#include "roomcast/codec/testing/synthetic_color.h"

namespace roomcast::codec {
namespace {

constexpr int kFrameWidth = 96, kFrameHeight = 80;
// Grey levels of 255, for smooth synthetic colour at the default rate: quantisation, and halved
// chroma at the disc's rim. In the smallest pictures most pixels are at the rim.
double most_color_rms(int width) {
  return width < 64 ? 25 : 12;
}

struct Payload {
  EncodedFrameInfo info;
  std::vector<std::uint8_t> bytes;
};

struct Stream {
  explicit Stream(FrameEncoderOptions options)
      : encoder(std::move(FrameEncoder::create(options)).value()) {}
  Payload next(const SyntheticFrame& frame, bool want_key = false) {
    Payload payload;
    payload.info =
        encoder->encode(frame.depth_mm, frame.color, frame.seen, want_key, payload.bytes).value();
    return payload;
  }
  Payload next_without_color(const SyntheticFrame& frame, bool want_key = false) {
    Payload payload;
    payload.info = encoder->encode(frame.depth_mm, {}, {}, want_key, payload.bytes).value();
    return payload;
  }
  std::unique_ptr<FrameEncoder> encoder;
};

FrameEncoderOptions options_for(int width, int height, int layers = 2) {
  FrameEncoderOptions options;
  options.width = width;
  options.height = height;
  options.depth_mode = DepthMode::kLossless;
  options.temporal_layers = layers;
  return options;
}

std::unique_ptr<FrameDecoder> decoder_for(int width, int height) {
  return std::move(FrameDecoder::create(width, height)).value();
}

/// Bytes of a stream; its colour rate is set before the first frame, or in the middle.
std::size_t stream_bytes(int first_kbit_per_s, int then_kbit_per_s) {
  auto encoder = FrameEncoder::create({.width = 320, .height = 240}).value();
  std::size_t bytes = 0;
  for (int i = 0; i < 40; ++i) {
    if (i == 0) encoder->set_color_rate(first_kbit_per_s);
    if (i == 20) encoder->set_color_rate(then_kbit_per_s);
    const SyntheticFrame frame = synthetic_frame(320, 240, i);
    std::vector<std::uint8_t> payload;
    EXPECT_TRUE(encoder->encode(frame.depth_mm, frame.color, frame.seen, false, payload).ok());
    if (i > 20) bytes += payload.size();
  }
  return bytes;
}

TEST(FrameCodec, a_lower_colour_rate_makes_frames_smaller_from_the_start_or_in_the_middle) {
  const std::size_t full = stream_bytes(2000, 2000);
  EXPECT_LT(stream_bytes(100, 100), full);
  EXPECT_LT(stream_bytes(2000, 100), full);
  EXPECT_GT(stream_bytes(2000, 0), 0u) << "limited to what is legal";
}

TEST(FrameCodec, gives_back_depth_and_mask_exactly_and_colour_nearly) {
  for (const auto& [width, height] : {std::pair{16, 16}, {17, 19}, {96, 80}, {131, 77}}) {
    Stream stream(options_for(width, height));
    auto decoder = decoder_for(width, height);
    DecodedFrame out;
    for (int i = 0; i < 6; ++i) {
      const SyntheticFrame frame = synthetic_frame(width, height, i);
      const Payload payload = stream.next(frame);
      EXPECT_EQ(payload.info.key, i == 0);
      EXPECT_EQ(payload.info.layer, i % 2);
      const Status status = decoder->decode(payload.bytes, out);
      ASSERT_TRUE(status.ok()) << status.error().message;
      EXPECT_EQ(out.depth_mm, frame.depth_mm);
      EXPECT_EQ(out.color_seen, frame.seen);
      EXPECT_LT(color_rms(out.color, frame.color, frame.seen), most_color_rms(width))
          << width << " " << i;
    }
  }
}

/// Repeats every pixel 2x2 times.
ColorImage twice_as_fine(const ColorImage& color) {
  ColorImage fine(2 * color.width(), 2 * color.height());
  for (int y = 0; y < fine.height(); ++y) {
    for (int x = 0; x < fine.width(); ++x) fine.at(x, y) = color.at(x / 2, y / 2);
  }
  return fine;
}

MaskImage twice_as_fine(const MaskImage& mask) {
  MaskImage fine(2 * mask.width(), 2 * mask.height());
  for (int y = 0; y < fine.height(); ++y) {
    for (int x = 0; x < fine.width(); ++x) fine.at(x, y) = mask.at(x / 2, y / 2);
  }
  return fine;
}

TEST(FrameCodec, colour_is_sent_without_a_reading_but_not_marked_valid) {
  for (const DepthMode mode : {DepthMode::kLossless, DepthMode::kLive}) {
    FrameEncoderOptions options = options_for(kFrameWidth, kFrameHeight);
    options.depth_mode = mode;
    Stream stream(options);
    SyntheticFrame frame;
    frame.depth_mm = DepthImage(kFrameWidth, kFrameHeight, 2000);
    frame.color = ColorImage(kFrameWidth, kFrameHeight, {200, 200, 200});
    frame.seen = MaskImage(kFrameWidth, kFrameHeight, 255);
    for (int y = 16; y < 64; ++y) {
      for (int x = 16; x < 64; ++x) {
        frame.depth_mm.at(x, y) = 0;
        frame.color.at(x, y) = {20, 20, 20};
      }
    }
    const auto decoder = decoder_for(kFrameWidth, kFrameHeight);
    DecodedFrame decoded;
    ASSERT_TRUE(decoder->decode(stream.next(frame, true).bytes, decoded).ok());
    EXPECT_NEAR(decoded.color.at(40, 40).r, 20, 10);
    EXPECT_EQ(decoded.color_seen.at(40, 40), 0);
    EXPECT_EQ(decoded.color_seen.at(5, 40), 255);
  }
}

TEST(FrameCodec, colour_may_be_twice_as_fine_as_depth) {
  FrameEncoderOptions options = options_for(kFrameWidth, kFrameHeight);
  options.color_scale = 2;
  Stream stream(options);
  auto decoder = decoder_for(kFrameWidth, kFrameHeight);
  DecodedFrame out;
  for (int i = 0; i < 6; ++i) {
    SyntheticFrame frame = synthetic_frame(kFrameWidth, kFrameHeight, i);
    frame.color = twice_as_fine(frame.color);
    ASSERT_TRUE(decoder->decode(stream.next(frame).bytes, out).ok());
    EXPECT_EQ(out.color_seen, frame.seen);
    ASSERT_EQ(out.color.width(), 2 * kFrameWidth);
    EXPECT_LT(color_rms(out.color, frame.color, twice_as_fine(frame.seen)),
              most_color_rms(kFrameWidth));
  }
}

TEST(FrameCodec, a_key_frame_may_change_how_fine_colour_is_and_no_other_frame) {
  FrameEncoderOptions fine_options = options_for(kFrameWidth, kFrameHeight);
  fine_options.color_scale = 2;
  Stream stream(options_for(kFrameWidth, kFrameHeight)), fine(fine_options);
  SyntheticFrame frame = synthetic_frame(kFrameWidth, kFrameHeight, 0), fine_frame = frame;
  fine_frame.color = twice_as_fine(frame.color);
  auto decoder = decoder_for(kFrameWidth, kFrameHeight);
  DecodedFrame out;
  ASSERT_TRUE(decoder->decode(stream.next(frame).bytes, out).ok());
  EXPECT_EQ(out.color.width(), kFrameWidth);
  ASSERT_TRUE(decoder->decode(fine.next(fine_frame).bytes, out).ok());
  EXPECT_EQ(out.color.width(), 2 * kFrameWidth);
  ASSERT_TRUE(decoder->decode(fine.next(fine_frame).bytes, out).ok());
  ASSERT_TRUE(decoder->decode(stream.next(frame, true).bytes, out).ok());
  EXPECT_EQ(out.color.width(), kFrameWidth);
}

TEST(FrameCodec, colour_is_not_finer_than_its_picture_may_be_large) {
  FrameEncoderOptions options = options_for(2048, 1024);
  options.color_scale = 2;
  EXPECT_TRUE(options.check().ok());
  options.width = 2049;
  EXPECT_FALSE(options.check().ok());
  options.color_scale = 1;
  EXPECT_TRUE(options.check().ok());
  options.color_scale = 3;
  EXPECT_FALSE(options.check().ok());
}

TEST(FrameCodec, one_layer_makes_every_frame_layer_0) {
  Stream stream(options_for(kFrameWidth, kFrameHeight, 1));
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(stream.next(synthetic_frame(kFrameWidth, kFrameHeight, i)).info.layer, 0);
  }
}

TEST(FrameCodec, layer_1_can_be_left_out_without_a_trace) {
  Stream stream(options_for(kFrameWidth, kFrameHeight));
  auto all = decoder_for(kFrameWidth, kFrameHeight),
       base_only = decoder_for(kFrameWidth, kFrameHeight);
  DecodedFrame from_all, from_base;
  int left_out = 0;
  for (int i = 0; i < 20; ++i) {
    const Payload payload = stream.next(synthetic_frame(kFrameWidth, kFrameHeight, i), i == 11);
    ASSERT_TRUE(all->decode(payload.bytes, from_all).ok());
    if (payload.info.layer > 0) {
      ++left_out;
      continue;
    }
    ASSERT_TRUE(base_only->decode(payload.bytes, from_base).ok());
    EXPECT_EQ(from_base.color, from_all.color) << i;
    EXPECT_EQ(from_base.depth_mm, from_all.depth_mm) << i;
  }
  EXPECT_GE(left_out, 9);
}

TEST(FrameCodec, a_key_frame_comes_when_asked_for_and_starts_a_new_decoder) {
  Stream stream(options_for(kFrameWidth, kFrameHeight));
  auto early = decoder_for(kFrameWidth, kFrameHeight);
  DecodedFrame from_early;
  for (int i = 0; i < 5; ++i) {
    const Payload payload = stream.next(synthetic_frame(kFrameWidth, kFrameHeight, i));
    ASSERT_TRUE(early->decode(payload.bytes, from_early).ok());
  }
  auto late = decoder_for(kFrameWidth, kFrameHeight);
  DecodedFrame from_late;
  for (int i = 5; i < 10; ++i) {
    const Payload payload = stream.next(synthetic_frame(kFrameWidth, kFrameHeight, i), i == 5);
    EXPECT_EQ(payload.info.key, i == 5);
    if (i == 5) {
      EXPECT_EQ(payload.info.layer, 0);
    }
    ASSERT_TRUE(early->decode(payload.bytes, from_early).ok());
    ASSERT_TRUE(late->decode(payload.bytes, from_late).ok());
    EXPECT_EQ(from_late.color, from_early.color);
  }
}

TEST(FrameCodec, without_colour_every_frame_is_a_key_frame) {
  Stream stream(options_for(kFrameWidth, kFrameHeight));
  auto decoder = decoder_for(kFrameWidth, kFrameHeight);
  DecodedFrame out;
  for (int i = 0; i < 3; ++i) {
    const SyntheticFrame frame = synthetic_frame(kFrameWidth, kFrameHeight, i);
    const Payload payload = stream.next_without_color(frame);
    EXPECT_TRUE(payload.info.key);
    EXPECT_EQ(payload.info.layer, 0);
    ASSERT_TRUE(decoder->decode(payload.bytes, out).ok());
    EXPECT_EQ(out.depth_mm, frame.depth_mm);
    EXPECT_TRUE(out.color.empty());
    EXPECT_TRUE(out.color_seen.empty());
  }
}

TEST(FrameCodec, a_frame_without_colour_between_others_can_be_left_out) {
  Stream stream(options_for(kFrameWidth, kFrameHeight));
  auto decoder = decoder_for(kFrameWidth, kFrameHeight);
  DecodedFrame out;
  ASSERT_TRUE(
      decoder->decode(stream.next(synthetic_frame(kFrameWidth, kFrameHeight, 0)).bytes, out).ok());
  const Payload without = stream.next_without_color(synthetic_frame(kFrameWidth, kFrameHeight, 1));
  EXPECT_FALSE(without.info.key);
  EXPECT_EQ(without.info.layer, 1);
  const Payload after = stream.next(synthetic_frame(kFrameWidth, kFrameHeight, 2));
  EXPECT_FALSE(after.info.key);
  EXPECT_TRUE(decoder->decode(after.bytes, out).ok());
}

TEST(FrameCodec, colour_starts_anew_after_a_key_frame_without_it) {
  Stream stream(options_for(kFrameWidth, kFrameHeight));
  (void)stream.next(synthetic_frame(kFrameWidth, kFrameHeight, 0));
  const Payload key =
      stream.next_without_color(synthetic_frame(kFrameWidth, kFrameHeight, 1), true);
  EXPECT_TRUE(key.info.key);
  const Payload after = stream.next(synthetic_frame(kFrameWidth, kFrameHeight, 2));
  EXPECT_TRUE(after.info.key);
  DecodedFrame out;
  EXPECT_TRUE(decoder_for(kFrameWidth, kFrameHeight)->decode(after.bytes, out).ok());
}

TEST(FrameCodec, a_delta_frame_alone_is_refused_until_a_key_frame_comes) {
  Stream stream(options_for(kFrameWidth, kFrameHeight));
  (void)stream.next(synthetic_frame(kFrameWidth, kFrameHeight, 0));
  const Payload delta = stream.next(synthetic_frame(kFrameWidth, kFrameHeight, 1));
  auto decoder = decoder_for(kFrameWidth, kFrameHeight);
  DecodedFrame out;
  EXPECT_EQ(decoder->decode(delta.bytes, out).error().code, ErrorCode::kMalformed);
  const Payload key = stream.next(synthetic_frame(kFrameWidth, kFrameHeight, 2), true);
  EXPECT_TRUE(decoder->decode(key.bytes, out).ok());
}

TEST(FrameCodec, encode_appends_and_refuses_pictures_of_another_size) {
  auto encoder = std::move(FrameEncoder::create(options_for(kFrameWidth, kFrameHeight))).value();
  const SyntheticFrame frame = synthetic_frame(kFrameWidth, kFrameHeight, 0);
  const SyntheticFrame other = synthetic_frame(kFrameWidth + 2, kFrameHeight, 0);
  std::vector<std::uint8_t> out{1, 2, 3};
  EXPECT_FALSE(encoder->encode(other.depth_mm, {}, {}, false, out).ok());
  EXPECT_FALSE(encoder->encode(frame.depth_mm, other.color, frame.seen, false, out).ok());
  EXPECT_FALSE(encoder->encode(frame.depth_mm, frame.color, {}, false, out).ok());
  EXPECT_FALSE(encoder->encode({}, {}, {}, false, out).ok());
  EXPECT_EQ(out.size(), 3u);
  ASSERT_TRUE(encoder->encode(frame.depth_mm, frame.color, frame.seen, false, out).ok());
  EXPECT_EQ(out[0], 1);
  DecodedFrame decoded;
  EXPECT_TRUE(
      decoder_for(kFrameWidth, kFrameHeight)->decode(std::span(out).subspan(3), decoded).ok());
}

TEST(FrameCodec, options_are_checked) {
  EXPECT_TRUE(options_for(16, 4096).check().ok());
  EXPECT_FALSE(options_for(15, 64).check().ok());
  EXPECT_FALSE(options_for(64, 4097).check().ok());
  EXPECT_FALSE(options_for(64, 64, 4).check().ok());
  FrameEncoderOptions options = options_for(64, 64);
  options.fps = std::nan("");
  EXPECT_FALSE(options.check().ok());
  options = options_for(64, 64);
  options.color_kbit_per_s = 0;
  EXPECT_FALSE(FrameEncoder::create(options).ok());
  EXPECT_FALSE(FrameDecoder::create(0, 64).ok());
  EXPECT_FALSE(FrameDecoder::create(64, 100000).ok());
}

TEST(FrameCodec, decode_refuses_another_size) {
  Stream stream(options_for(kFrameWidth, kFrameHeight));
  const Payload payload = stream.next(synthetic_frame(kFrameWidth, kFrameHeight, 0));
  DecodedFrame out;
  EXPECT_FALSE(decoder_for(kFrameWidth, kFrameHeight + 2)->decode(payload.bytes, out).ok());
  EXPECT_FALSE(decoder_for(kFrameHeight, kFrameWidth)->decode(payload.bytes, out).ok());
}

TEST(FrameCodec, decode_refuses_colour_of_another_size) {
  Stream small(options_for(48, 48)), right(options_for(kFrameWidth, kFrameHeight));
  const Payload from_small = small.next(synthetic_frame(48, 48, 0));
  const Payload from_right = right.next(synthetic_frame(kFrameWidth, kFrameHeight, 0));
  const auto small_sections = parse_sections(from_small.bytes, 48, 48).value();
  const auto sections = parse_sections(from_right.bytes, kFrameWidth, kFrameHeight).value();
  std::vector<std::uint8_t> mixed;
  const auto append = [&](SectionKind kind, std::span<const std::uint8_t> bytes) {
    const std::size_t begin = begin_section(kind, 1, mixed);
    mixed.insert(mixed.end(), bytes.begin(), bytes.end());
    end_section(begin, mixed);
  };
  append(SectionKind::kDepth, sections.depth);
  append(SectionKind::kColor, small_sections.color);
  append(SectionKind::kColorMask, sections.color_mask);
  DecodedFrame out;
  EXPECT_EQ(decoder_for(kFrameWidth, kFrameHeight)->decode(mixed, out).error().code,
            ErrorCode::kMalformed);
}

TEST(FrameCodec, decode_recovers_with_the_next_key_frame_after_any_damage) {
  std::mt19937 random(3);
  Stream stream(options_for(kFrameWidth, kFrameHeight));
  const Payload key = stream.next(synthetic_frame(kFrameWidth, kFrameHeight, 0));
  const Payload delta = stream.next(synthetic_frame(kFrameWidth, kFrameHeight, 1));
  auto decoder = decoder_for(kFrameWidth, kFrameHeight);
  DecodedFrame out;
  for (int trial = 0; trial < 150; ++trial) {
    for (const Payload* good : {&key, &delta}) {
      std::vector<std::uint8_t> bytes = good->bytes;
      bytes.resize(random() % 3 ? bytes.size() : random() % bytes.size());
      for (int flip = 0; flip < 3 && !bytes.empty(); ++flip) {
        bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1 << random() % 8);
      }
      (void)decoder->decode(bytes, out);
    }
    ASSERT_TRUE(decoder->decode(key.bytes, out).ok()) << trial;
    ASSERT_EQ(out.depth_mm, synthetic_frame(kFrameWidth, kFrameHeight, 0).depth_mm);
  }
}

}  // namespace
}  // namespace roomcast::codec
