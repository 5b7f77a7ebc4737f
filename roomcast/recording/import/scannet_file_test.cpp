// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/scannet_file.h"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "roomcast/io/jpeg_codec.h"

namespace roomcast::recording {
namespace {

using SensBytes = std::vector<std::uint8_t>;

template <class Number>
void append(SensBytes& out, Number number) {
  const auto at = out.size();
  out.resize(at + sizeof(number));
  std::memcpy(out.data() + at, &number, sizeof(number));
}

void append_matrix(SensBytes& out, float fx, float cx, float cy, float x) {
  for (const float value :
       {fx, 0.F, cx, x, 0.F, fx, cy, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 0.F, 1.F})
    append(out, value);
}

/// Two frames of 4 x 3 depth and 8 x 6 colour, 50 ms apart.
SensBytes scannet_recording(bool zlib, float depth_shift = 1000) {
  SensBytes out;
  append(out, std::uint32_t{4});
  append(out, std::uint64_t{5});
  for (const char c : std::string("Sense")) append(out, c);
  append_matrix(out, 10, 3.5F, 2.5F, 0), append_matrix(out, 1, 0, 0, 0.25F);
  append_matrix(out, 5, 1.5F, 1, 0), append_matrix(out, 1, 0, 0, 0);
  append(out, std::int32_t{2});
  append(out, std::int32_t{zlib ? 1 : 0});
  for (const std::uint32_t side : {8U, 6U, 4U, 3U}) append(out, side);
  append(out, depth_shift);
  append(out, std::uint64_t{2});
  for (int frame = 0; frame < 2; ++frame) {
    SensBytes color, depth;
    io::JpegCodec jpeg;
    const auto grey = static_cast<std::uint8_t>(90 + 40 * frame);
    EXPECT_EQ(jpeg.encode(ColorImage(8, 6, {grey, grey, grey}), 95, color), "");
    for (int i = 0; i < 12; ++i) append(depth, static_cast<std::uint16_t>(1000 * (frame + 1) + i));
    if (zlib) {
      SensBytes packed(compressBound(depth.size()));
      uLongf size = packed.size();
      EXPECT_EQ(compress(packed.data(), &size, depth.data(), depth.size()), Z_OK);
      packed.resize(size);
      depth = packed;
    }
    append_matrix(out, 1, 0, 0, 3);
    append(out, std::uint64_t{7});
    append(out, std::uint64_t(1'000'000 + 50'000 * frame));
    append(out, std::uint64_t{color.size()});
    append(out, std::uint64_t{depth.size()});
    out.insert(out.end(), color.begin(), color.end());
    out.insert(out.end(), depth.begin(), depth.end());
  }
  append(out, std::uint64_t{0});
  return out;
}

TEST(ScanNetFile, gives_depth_colour_cameras_and_times) {
  for (const bool zlib : {false, true}) {
    const auto file = read_scannet_file(bytes_in_memory(scannet_recording(zlib)), "scene.sens");
    ASSERT_TRUE(file.ok()) << file.error().message;
    EXPECT_THAT((*file)->info().times, testing::ElementsAre(std::chrono::milliseconds(1000),
                                                            std::chrono::milliseconds(1050)));
    const SensorCalibration& cameras = (*file)->info().description.calibration;
    EXPECT_EQ(cameras.depth.fx, 5);
    EXPECT_EQ(cameras.color.width, 8);
    EXPECT_EQ(cameras.color_from_depth.translation_m.x(), 0.25);
    DepthImage depth;
    ColorImage color;
    SensBytes jpeg;
    ASSERT_TRUE((*file)->read_depth(1, depth).ok());
    EXPECT_EQ(depth.at(3, 2), 2011);
    ASSERT_TRUE((*file)->read_color(1, color).ok());
    EXPECT_NEAR(color.at(4, 4).g, 130, 2);
    ASSERT_TRUE((*file)->read_jpeg(0, jpeg).ok());
    EXPECT_FALSE(jpeg.empty());
  }
}

TEST(ScanNetFile, depth_in_another_unit_becomes_millimetres) {
  const auto file = read_scannet_file(bytes_in_memory(scannet_recording(false, 500)), "a");
  DepthImage depth;
  ASSERT_TRUE((*file)->read_depth(0, depth).ok());
  EXPECT_EQ(depth.at(0, 0), 2000);
}

TEST(ScanNetFile, cut_or_damaged_anywhere_it_is_refused_or_read_in_part) {
  const SensBytes whole = scannet_recording(true);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto file = read_scannet_file(
        bytes_in_memory({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}), "cut");
    if (file) {
      DepthImage depth;
      EXPECT_TRUE((*file)->read_depth(0, depth).ok());
    }
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    SensBytes bytes = whole;
    bytes[at] ^= 0xFF;
    const auto file = read_scannet_file(bytes_in_memory(bytes), "damaged");
    if (!file) continue;
    DepthImage depth;
    ColorImage color;
    for (std::size_t i = 0; i < (*file)->info().times.size(); ++i) {
      (void)(*file)->read_depth(i, depth);
      (void)(*file)->read_color(i, color);
    }
  }
}

TEST(ScanNetFile, other_versions_are_refused) {
  SensBytes bytes = scannet_recording(false);
  bytes[0] = 3;
  EXPECT_EQ(read_scannet_file(bytes_in_memory(bytes), "a").error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(read_scannet_file(bytes_in_memory({}), "a").error().code, ErrorCode::kMalformed);
}

}  // namespace
}  // namespace roomcast::recording
