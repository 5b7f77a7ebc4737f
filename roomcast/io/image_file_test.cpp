// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/image_file.h"

#include <gtest/gtest.h>

#include "roomcast/io/jpeg_codec.h"
#include "roomcast/io/png_codec.h"
#include "roomcast/recording/dataset/recording_fixture.h"

namespace roomcast::io {
namespace {

DepthImage some_depth() {
  return recording::small_frame(0, 3).depth_mm;
}

ColorImage some_color() {
  ColorImage color(64, 48);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      color.at(x, y) = {static_cast<std::uint8_t>(4 * x), static_cast<std::uint8_t>(5 * y), 128};
    }
  }
  return color;
}

constexpr ImageSize kDepthSize{recording::kSmallWidth, recording::kSmallHeight};
constexpr ImageSize kColorSize{64, 48};

class ImageFile : public testing::Test {
 protected:
  /// Expects that both readers refuse the file with `code`, in a sentence that names it.
  void expect_refused(const std::string& name, ErrorCode code) {
    for (const Status& status : {reader_.read_depth(folder_ / name, kDepthSize, depth_),
                                 reader_.read_color(folder_ / name, kColorSize, color_)}) {
      ASSERT_FALSE(status.ok()) << name;
      EXPECT_EQ(status.error().code, code) << status.error().message;
      EXPECT_NE(status.error().message.find(name), std::string::npos) << status.error().message;
    }
  }

  TemporaryFolder folder_;
  ImageFileReader reader_;
  DepthImage depth_;
  ColorImage color_;
};

TEST_F(ImageFile, depth_comes_back_bit_for_bit) {
  DepthImage depth = some_depth();
  depth.at(0, 0) = 0;
  depth.at(1, 0) = 65535;
  depth.at(2, 0) = 0x0102;
  ASSERT_TRUE(write_depth_png(folder_ / "d.png", depth).ok());
  ASSERT_TRUE(reader_.read_depth(folder_ / "d.png", kDepthSize, depth_).ok());
  EXPECT_EQ(depth_, depth);
}

TEST_F(ImageFile, colour_png_comes_back_bit_for_bit) {
  ASSERT_TRUE(write_color_png(folder_ / "c.png", some_color()).ok());
  ASSERT_TRUE(reader_.read_color(folder_ / "c.png", kColorSize, color_).ok());
  EXPECT_EQ(color_, some_color());
}

TEST_F(ImageFile, mask_comes_back_bit_for_bit_and_is_no_depth) {
  MaskImage mask(recording::kSmallWidth, recording::kSmallHeight, 0), read;
  mask.at(3, 2) = 255;
  mask.at(4, 2) = 7;
  ASSERT_TRUE(write_mask_png(folder_ / "m.png", mask).ok());
  ASSERT_TRUE(reader_.read_mask(folder_ / "m.png", kDepthSize, read).ok());
  EXPECT_EQ(read, mask);
  EXPECT_FALSE(reader_.read_depth(folder_ / "m.png", kDepthSize, depth_).ok());
  ASSERT_TRUE(write_depth_png(folder_ / "d.png", some_depth()).ok());
  EXPECT_FALSE(reader_.read_mask(folder_ / "d.png", kDepthSize, read).ok());
}

TEST_F(ImageFile, colour_jpeg_comes_back_nearly) {
  ASSERT_TRUE(write_color_jpeg(folder_ / "c.jpg", some_color(), 95).ok());
  ASSERT_TRUE(reader_.read_color(folder_ / "c.jpg", kColorSize, color_).ok());
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      EXPECT_NEAR(color_.at(x, y).r, 4 * x, 12);
      EXPECT_NEAR(color_.at(x, y).g, 5 * y, 12);
    }
  }
}

TEST_F(ImageFile, content_decides_between_jpeg_and_png) {
  ASSERT_TRUE(write_color_png(folder_ / "c.jpg", some_color()).ok());
  EXPECT_TRUE(reader_.read_color(folder_ / "c.jpg", kColorSize, color_).ok());
}

TEST_F(ImageFile, memory_is_used_again) {
  ASSERT_TRUE(write_depth_png(folder_ / "d.png", some_depth()).ok());
  ASSERT_TRUE(reader_.read_depth(folder_ / "d.png", kDepthSize, depth_).ok());
  const std::uint16_t* const pixels = depth_.data();
  ASSERT_TRUE(reader_.read_depth(folder_ / "d.png", kDepthSize, depth_).ok());
  EXPECT_EQ(depth_.data(), pixels);
}

TEST_F(ImageFile, missing_and_empty_files_are_refused) {
  expect_refused("none.png", ErrorCode::kNotFound);
  recording::put_text(folder_ / "empty.png", "");
  expect_refused("empty.png", ErrorCode::kMalformed);
  recording::put_text(folder_ / "text.png", "this is no picture, only text that is long enough");
  expect_refused("text.png", ErrorCode::kMalformed);
}

TEST_F(ImageFile, truncated_files_are_refused_wherever_they_end) {
  for (const double share : {0.02, 0.3, 0.6, 0.9, 0.99}) {
    ASSERT_TRUE(write_depth_png(folder_ / "d.png", some_depth()).ok());
    ASSERT_TRUE(write_color_jpeg(folder_ / "c.jpg", some_color(), 95).ok());
    ASSERT_TRUE(write_color_png(folder_ / "c.png", some_color()).ok());
    for (const char* name : {"d.png", "c.jpg", "c.png"})
      recording::truncate_file(folder_ / name, share);
    EXPECT_FALSE(reader_.read_depth(folder_ / "d.png", kDepthSize, depth_).ok()) << share;
    EXPECT_FALSE(reader_.read_color(folder_ / "c.jpg", kColorSize, color_).ok()) << share;
    EXPECT_FALSE(reader_.read_color(folder_ / "c.png", kColorSize, color_).ok()) << share;
  }
}

TEST_F(ImageFile, a_flipped_byte_in_a_png_is_noticed) {
  ASSERT_TRUE(write_depth_png(folder_ / "d.png", some_depth()).ok());
  std::string bytes = recording::text_of(folder_ / "d.png");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x40);
  recording::put_text(folder_ / "d.png", bytes);
  EXPECT_FALSE(reader_.read_depth(folder_ / "d.png", kDepthSize, depth_).ok());
}

TEST_F(ImageFile, pictures_of_another_size_are_refused) {
  ASSERT_TRUE(write_depth_png(folder_ / "d.png", DepthImage(30, 40, 7)).ok());
  ASSERT_TRUE(write_color_png(folder_ / "c.png", ColorImage(65, 48)).ok());
  ASSERT_TRUE(write_color_jpeg(folder_ / "c.jpg", ColorImage(64, 47), 90).ok());
  const Status status = reader_.read_depth(folder_ / "d.png", kDepthSize, depth_);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().message,
            (folder_ / "d.png").string() + " is refused: its size differs from the calibration");
  EXPECT_FALSE(reader_.read_color(folder_ / "c.png", kColorSize, color_).ok());
  EXPECT_FALSE(reader_.read_color(folder_ / "c.jpg", kColorSize, color_).ok());
}

TEST_F(ImageFile, colour_is_no_depth) {
  ASSERT_TRUE(write_color_png(folder_ / "c.png",
                              ColorImage(recording::kSmallWidth, recording::kSmallHeight))
                  .ok());
  const Status status = reader_.read_depth(folder_ / "c.png", kDepthSize, depth_);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().message.find("16-bit grey"), std::string::npos);
}

TEST_F(ImageFile, a_header_of_a_huge_picture_allocates_nothing) {
  ASSERT_TRUE(write_depth_png(folder_ / "d.png", some_depth()).ok());
  std::vector<std::uint8_t> bytes;
  ASSERT_TRUE(encode_depth_png(some_depth(), bytes).empty());
  bytes[16] = 0x7F;  // the width's highest byte; its checksum is wrong now, too
  EXPECT_FALSE(
      decode_depth_png(bytes, DepthImage(recording::kSmallWidth, recording::kSmallHeight).view())
          .empty());
}

TEST_F(ImageFile, files_larger_than_any_picture_are_not_read) {
  recording::put_text(folder_ / "large.png", "");
  std::filesystem::resize_file(folder_ / "large.png", kMaxImageFileBytes + 1);  // sparse
  expect_refused("large.png", ErrorCode::kTooLarge);
}

TEST_F(ImageFile, a_failed_write_is_reported) {
  const Status status = write_depth_png(folder_ / "none/d.png", some_depth());
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kUnavailable);
}

TEST(JpegCodec, survives_random_damage) {
  JpegCodec codec;
  std::vector<std::uint8_t> bytes;
  ASSERT_TRUE(codec.encode(some_color(), 80, bytes).empty());
  ColorImage color(64, 48);
  std::uint32_t state = 1;
  for (int round = 0; round < 300; ++round) {
    std::vector<std::uint8_t> damaged = bytes;
    for (int i = 0; i < 4; ++i) {
      state = state * 1664525U + 1013904223U;
      damaged[(state >> 8) % damaged.size()] = static_cast<std::uint8_t>(state >> 24);
    }
    (void)codec.decode(damaged, color.view());  // may fail, must not crash
  }
  EXPECT_EQ(codec.decode(bytes, color.view()), "");  // the codec works again afterwards
}

}  // namespace
}  // namespace roomcast::io
