// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/vp9_color_encoder.h"

#include <random>

#include <gtest/gtest.h>

#include "roomcast/codec/color/vp9_color_decoder.h"
#include "roomcast/codec/testing/synthetic_color.h"

namespace roomcast::codec {
namespace {

constexpr int kColorWidth = 160, kColorHeight = 128;

/// A picture of patches of random grey.
ColorImage patches(unsigned seed = 0) {
  constexpr int kPatch = 3;
  std::mt19937 random(seed);
  Image<std::uint8_t> grey(kColorWidth / kPatch + 1, kColorHeight / kPatch + 1);
  for (std::size_t i = 0; i < grey.view().pixel_count(); ++i) {
    grey.data()[i] = static_cast<std::uint8_t>(60 + random() % 120);
  }
  ColorImage color(kColorWidth, kColorHeight);
  for (int y = 0; y < kColorHeight; ++y) {
    for (int x = 0; x < kColorWidth; ++x) {
      const std::uint8_t value = grey.at(x / kPatch, y / kPatch);
      color.at(x, y) = {value, value, value};
    }
  }
  return color;
}

ColorImage with_something_before(ColorImage color) {
  for (int y = 0; y < kColorHeight; ++y) {
    for (int x = 0; x < kColorWidth / 2; ++x) color.at(x, y) = {90, 90, 90};
  }
  return color;
}

class EncodedStream {
 public:
  EncodedStream()
      : seen_(kColorWidth, kColorHeight, 255),
        encoder_(Vp9ColorEncoder::create(options()).value()),
        decoder_(Vp9ColorDecoder::create(kColorWidth, kColorHeight).value()) {}

  /// Encodes a frame and returns its number of bytes.
  std::size_t next(const ColorImage& color, bool key = false) {
    std::vector<std::uint8_t> bytes;
    EXPECT_TRUE(encoder_->encode(color, seen_, {key, 0}, bytes).ok());
    EXPECT_TRUE(decoder_->decode(bytes, shown_).ok());
    return bytes.size();
  }
  [[nodiscard]] double rms(const ColorImage& wanted) const {
    return color_rms(shown_, wanted, seen_);
  }

 private:
  static FrameEncoderOptions options() {
    FrameEncoderOptions options;
    options.width = kColorWidth;
    options.height = kColorHeight;
    options.temporal_layers = 1;
    return options;
  }
  MaskImage seen_;
  ColorImage shown_;
  std::unique_ptr<Vp9ColorEncoder> encoder_;
  std::unique_ptr<Vp9ColorDecoder> decoder_;
};

TEST(Vp9ColorEncoder, a_surface_that_comes_back_into_view_is_as_fine_as_before) {
  EncodedStream stream;
  const ColorImage room = patches(), covered = with_something_before(room);
  const std::size_t first = stream.next(room, true);
  const double rms = stream.rms(room);
  for (int i = 0; i < 12; ++i) stream.next(covered);
  ASSERT_LT(stream.rms(covered), 2 * rms);
  EXPECT_LT(stream.next(room), first / 8);
  EXPECT_LT(stream.rms(room), 1.5 * rms);
}

/// Ratio of the bytes of the second key frame to those of the first, of the same picture.
double later_key_share(bool moving) {
  EncodedStream stream;
  const std::size_t first = stream.next(patches(), true);
  for (unsigned i = 1; i < 60; ++i) stream.next(patches(moving ? i : 0));
  return static_cast<double>(stream.next(patches(), true)) / static_cast<double>(first);
}

TEST(Vp9ColorEncoder, later_key_frames_of_a_room_where_nothing_moves_are_coarser) {
  EXPECT_LT(later_key_share(false), 0.9);
}

TEST(Vp9ColorEncoder, later_key_frames_of_a_room_in_motion_are_as_fine_as_the_first) {
  EXPECT_GT(later_key_share(true), 0.95);
}

}  // namespace
}  // namespace roomcast::codec
