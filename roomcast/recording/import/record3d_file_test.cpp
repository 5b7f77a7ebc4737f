// SPDX-License-Identifier: Apache-2.0
// Recordings are written by the tests after the format's description. Depth of 96 x 64 in
// fuzz/corpus/lzfse/entropy was compressed by Apple's reference (lzfse_test.cpp).
#include "roomcast/recording/import/record3d_file.h"

#include <cstring>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/io/jpeg_codec.h"
#include "roomcast/recording/zip/zip_fixture.h"

namespace roomcast::recording {
namespace {

using R3dBytes = ZipWriter::Bytes;

constexpr const char* kR3dMetadata =
    R"({"w": 192, "h": 128, "dw": 96, "dh": 64, "fps": 30,
        "K": [200, 0, 0, 0, 202, 0, 95.5, 63.5, 1],
        "frameTimestamps": [10, 10.05, 10.125], "poses": [[0, 0, 0, 1, 0, 0, 0]]})";

R3dBytes compressed_wall() {
  std::ifstream file(std::string(ROOMCAST_SOURCE_DIR) + "/fuzz/corpus/lzfse/entropy",
                     std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Depth of `metres` everywhere: a plain block of LZFSE, or the bare values.
R3dBytes flat_depth(float metres, bool bare = false) {
  R3dBytes out;
  const auto append = [&out](const void* bytes, std::size_t size) {
    const auto* const from = static_cast<const std::uint8_t*>(bytes);
    out.insert(out.end(), from, from + size);
  };
  const std::uint32_t size = 96 * 64 * sizeof(float);
  if (!bare) append("bvx-", 4), append(&size, 4);
  for (int i = 0; i < 96 * 64; ++i) append(&metres, sizeof(metres));
  if (!bare) append("bvx$", 4);
  return out;
}

R3dBytes grey_jpeg(std::uint8_t grey) {
  R3dBytes out;
  io::JpegCodec jpeg;
  EXPECT_EQ(jpeg.encode(ColorImage(192, 128, {grey, grey, grey}), 95, out), "");
  return out;
}

ZipWriter small_recording(const std::string& metadata = kR3dMetadata) {
  ZipWriter writer;
  writer.add("metadata", metadata, true)
      .add("icon", grey_jpeg(1))
      .add("rgbd/0.depth", compressed_wall())
      .add("rgbd/0.jpg", grey_jpeg(80))
      .add("rgbd/0.conf", "not read")
      .add("rgbd/1.depth", flat_depth(1.2345F))
      .add("rgbd/1.jpg", grey_jpeg(160))
      .add("rgbd/2.depth", flat_depth(2, true));
  return writer;
}

Result<std::unique_ptr<SensorFile>> read_r3d(const ZipWriter& recording) {
  return read_record3d_file(bytes_in_memory(recording.done()), "scans/lab.r3d");
}

std::string r3d_problem(const std::string& metadata) {
  const auto file = read_r3d(small_recording(metadata));
  return file ? "it was read" : file.error().message;
}

TEST(Record3dFile, gives_depth_colour_camera_and_times) {
  const auto file = read_r3d(small_recording());
  ASSERT_TRUE(file.ok()) << file.error().message;
  const SensorFileInfo& info = (*file)->info();
  EXPECT_EQ(info.description.name, "lab");
  EXPECT_THAT(info.times,
              testing::ElementsAre(nanoseconds(10'000'000'000), nanoseconds(10'050'000'000),
                                   nanoseconds(10'125'000'000)));
  const SensorCalibration& calibration = info.description.calibration;
  EXPECT_EQ(calibration.color.fx, 200);
  EXPECT_EQ(calibration.color.cy, 63.5);
  EXPECT_EQ(calibration.depth.width, 96);
  EXPECT_EQ(calibration.depth.fx, 100);
  EXPECT_EQ(calibration.depth.fy, 101);
  EXPECT_EQ(calibration.depth.cx, 47.5);  // the middle stays the middle
  EXPECT_EQ(calibration.depth.cy, 31.5);
  EXPECT_FALSE(calibration.color_is_registered);
  DepthImage depth;
  ASSERT_TRUE((*file)->read_depth(0, depth).ok());
  ASSERT_EQ(depth.width(), 96);
  EXPECT_EQ(depth.at(0, 0), 0);  // no reading
  EXPECT_EQ(depth.at(1, 0), std::lround((1000 + 3 + (7919 >> 4) % 5) / 1.024));
  ASSERT_TRUE((*file)->read_depth(1, depth).ok());
  EXPECT_EQ(depth.at(95, 63), 1235);  // 1234.5 mm
  ASSERT_TRUE((*file)->read_depth(2, depth).ok());
  EXPECT_EQ(depth.at(5, 5), 2000);
  ColorImage color;
  ASSERT_TRUE((*file)->read_color(1, color).ok());
  EXPECT_NEAR(color.at(100, 100).g, 160, 2);
  std::vector<std::uint8_t> jpeg;
  ASSERT_TRUE((*file)->read_jpeg(1, jpeg).ok());
  EXPECT_EQ(jpeg, grey_jpeg(160));
  ASSERT_TRUE((*file)->read_color(2, color).ok());
  EXPECT_TRUE(color.empty());
}

TEST(Record3dFile, times_that_are_missing_are_those_of_the_rate) {
  for (const char* times : {"null", "[5]", "[3, 2, 1]", "[0, 1e300, 2]"}) {
    const std::string metadata = R"({"w": 192, "h": 128, "dw": 96, "dh": 64, "fps": 20,
        "K": [200, 0, 0, 0, 202, 0, 95.5, 63.5, 1], "frameTimestamps": )" +
                                 std::string(times) + "}";
    const auto file = read_r3d(small_recording(metadata));
    ASSERT_TRUE(file.ok()) << file.error().message;
    EXPECT_EQ((*file)->info().times[2], std::chrono::milliseconds(100)) << times;
  }
}

TEST(Record3dFile, a_size_that_is_not_told_is_found) {
  ZipWriter writer;
  R3dBytes depth(192 * 256 * sizeof(float));
  writer.add("metadata", R"({"w": 720, "h": 960, "K": [700, 0, 0, 0, 700, 0, 360, 480, 1]})")
      .add("rgbd/0.depth", depth);
  const auto file = read_r3d(writer);
  ASSERT_TRUE(file.ok()) << file.error().message;
  EXPECT_EQ((*file)->info().description.calibration.depth.width, 192);
  EXPECT_EQ((*file)->info().description.calibration.depth.height, 256);
  EXPECT_FALSE((*file)->info().has_color);
}

TEST(Record3dFile, damaged_pictures_leave_the_others) {
  ZipWriter writer = small_recording();
  R3dBytes broken = compressed_wall();
  broken.resize(broken.size() / 2);
  writer.add("rgbd/3.depth", broken).add("rgbd/3.jpg", "no picture");
  const auto file = read_r3d(writer);
  ASSERT_TRUE(file.ok()) << file.error().message;
  DepthImage depth;
  const Status status = (*file)->read_depth(3, depth);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().message,
            "scans/lab.r3d: a depth picture in it is damaged, or of another size");
  ColorImage color;
  EXPECT_FALSE((*file)->read_color(3, color).ok());
  EXPECT_TRUE((*file)->read_depth(1, depth).ok());
}

TEST(Record3dFile, what_is_no_recording_is_a_sentence) {
  EXPECT_EQ(r3d_problem("[]"), "scans/lab.r3d: its metadata is not a JSON object");
  EXPECT_EQ(r3d_problem("{}"), "scans/lab.r3d: its metadata lacks the camera's matrix \"K\"");
  EXPECT_THAT(r3d_problem(R"({"w": 1e9, "h": 3, "K": [1, 0, 0, 0, 1, 0, 0, 0, 1]})"),
              testing::StartsWith("scans/lab.r3d: the camera of it is invalid: "));
  ZipWriter other;
  other.add("readme.txt", "hello");
  EXPECT_EQ(read_r3d(other).error().code, ErrorCode::kUnsupported);
  ZipWriter none;
  none.add("metadata", kR3dMetadata);
  EXPECT_EQ(read_r3d(none).error().message, "scans/lab.r3d: it has no frames");
  EXPECT_EQ(read_record3d_file(bytes_in_memory({1, 2, 3}), "x").error().message,
            "x: it is not a ZIP file, or its end is missing");
  EXPECT_EQ(open_record3d_file("/nowhere.r3d").error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::recording
