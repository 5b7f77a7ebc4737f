// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/azure_kinect_file.h"

#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/recording/import/azure_kinect_calibration.h"
#include "roomcast/recording/import/azure_kinect_fixture.h"

namespace roomcast::recording {
namespace {

std::unique_ptr<SensorFile> opened(const AzureFixture& made) {
  auto file = read_azure_kinect_file(bytes_in_memory(azure_recording(made)), "a.mkv");
  EXPECT_TRUE(file.ok()) << (file.ok() ? "" : file.error().message);
  return file.ok() ? *std::move(file) : nullptr;
}

Error refused(const matroska::FixtureBytes& bytes) {
  const auto file = read_azure_kinect_file(bytes_in_memory(bytes), "a.mkv");
  EXPECT_FALSE(file.ok());
  return file.ok() ? Error{} : file.error();
}

TEST(AzureKinectFile, gives_depth_bit_for_bit_and_the_colour_of_the_same_instant) {
  for (const char* format : {"MJPG", "NV12", "YUY2"}) {
    AzureFixture made;
    made.color = format;
    const auto file = opened(made);
    ASSERT_TRUE(file) << format;
    ASSERT_EQ(file->info().times.size(), 3U);
    for (int i = 0; i < 3; ++i) {
      DepthImage depth;
      ColorImage color;
      ASSERT_TRUE(file->read_depth(static_cast<std::size_t>(i), depth).ok());
      ASSERT_TRUE(file->read_color(static_cast<std::size_t>(i), color).ok());
      ASSERT_EQ(depth.width(), kAzureDepthWidth);
      for (const auto& [x, y] : {std::pair(0, 0), {319, 287}, {17, 200}})
        EXPECT_EQ(depth.at(x, y), azure_depth_mm(i, x, y));
      ASSERT_EQ(color.width(), kAzureColorWidth);
      EXPECT_NEAR(color.at(600, 300).g, 40 + 30 * i, 2) << format;
      EXPECT_NEAR(color.at(600, 300).r, color.at(600, 300).b, 1) << format;
    }
  }
}

TEST(AzureKinectFile, times_are_those_of_the_camera) {
  AzureFixture made;
  made.start_offset_us = 336'277;
  made.first_us = 463'945;
  const auto file = opened(made);
  EXPECT_EQ(file->info().times[0], std::chrono::microseconds(800'222));
  EXPECT_EQ(file->info().times[1] - file->info().times[0], std::chrono::microseconds(33'333));
  EXPECT_NEAR(file->info().description.fps, 30, 0.1);
  ASSERT_TRUE(file->info().clock.utc_minus_device);
  EXPECT_EQ(file->info().times[0] + *file->info().clock.utc_minus_device,
            nanoseconds((978'307'200LL + 600'000'000LL) * 1'000'000'000LL) +
                std::chrono::microseconds(463'945));
}

TEST(AzureKinectFile, depth_that_is_taken_later_than_colour_keeps_its_colour_and_its_own_time) {
  AzureFixture made;
  made.depth_delay_us = 20'000;  // more than half a frame
  const auto file = opened(made);
  EXPECT_EQ(file->info().times[0], std::chrono::microseconds(620'000));
  ColorImage color;
  ASSERT_TRUE(file->read_color(0, color).ok());
  EXPECT_NEAR(color.at(600, 300).g, 40, 2);
}

TEST(AzureKinectFile, a_recording_without_colour_has_depth_alone) {
  AzureFixture made;
  made.color = "";
  const auto file = opened(made);
  EXPECT_FALSE(file->info().has_color);
  ColorImage color(3, 3);
  ASSERT_TRUE(file->read_color(1, color).ok());
  EXPECT_TRUE(color.empty());
}

TEST(AzureKinectFile, says_which_cable_joined_it) {
  AzureFixture made;
  made.sync = "MASTER";
  EXPECT_TRUE(opened(made)->info().clock.is_cable_primary);
  made.sync = "SUBORDINATE";
  EXPECT_TRUE(opened(made)->info().clock.is_cable_secondary);
  EXPECT_EQ(opened(made)->info().description.name, "000123");
}

TEST(AzureKinectFile, other_recordings_and_damage_get_a_sentence) {
  EXPECT_EQ(refused({}).code, ErrorCode::kMalformed);
  AzureFixture made;
  made.calibration = "{\"CalibrationInformation\": 3}";
  EXPECT_THAT(refused(azure_recording(made)).message, testing::HasSubstr("calibration.json"));
  made.calibration = "[[[";
  EXPECT_EQ(refused(azure_recording(made)).code, ErrorCode::kMalformed);
  made = {};
  made.frames = 0;
  EXPECT_THAT(refused(azure_recording(made)).message, testing::HasSubstr("a.mkv: "));
  made = {};
  made.color = "XVID";
  EXPECT_EQ(refused(azure_recording(made)).code, ErrorCode::kUnsupported);
}

TEST(AzureKinectFile, a_picture_that_is_too_short_is_reported_and_the_next_one_is_read) {
  AzureFixture made;
  matroska::FixtureBytes bytes = azure_recording(made);
  bytes.erase(bytes.end() - 200'000, bytes.end());  // within the last cluster
  const auto file = read_azure_kinect_file(bytes_in_memory(bytes), "a.mkv");
  ASSERT_TRUE(file.ok()) << file.error().message;
  EXPECT_EQ((*file)->info().times.size(), 2U);
  ASSERT_FALSE((*file)->info().notes.empty());
  EXPECT_THAT((*file)->info().notes[0], testing::HasSubstr("ends too early"));
}

/// The point of a ray that OpenCV's formula for eight coefficients projects to a pixel.
TEST(AzureKinectCalibration, a_known_point_projects_to_the_pixel_of_the_makers_formula) {
  const std::vector<std::uint8_t> json(kAzureCalibration.begin(), kAzureCalibration.end());
  const auto read = read_azure_kinect_calibration(json, "NFOV_UNBINNED", 720);
  ASSERT_TRUE(read.ok()) << read.error().message;
  const Eigen::Vector3d point(0.4, -0.3, 1.0);
  const double x = 0.4, y = -0.3, r2 = x * x + y * y;
  const double factor = (1 + r2 * (0.55 + r2 * (-0.021 + r2 * -0.0027))) /
                        (1 + r2 * (0.89 + r2 * (0.086 + r2 * -0.014)));
  const double p1 = 2e-5, p2 = -7e-5;
  const auto pixel = project(read->cameras.depth, point);
  ASSERT_TRUE(pixel);
  const double xd = x * factor + 2 * p1 * x * y + p2 * (r2 + 2 * x * x);
  EXPECT_NEAR(pixel->x(), 0.49 * 1024 * xd + 0.51 * 1024 - 192 - 0.5, 0.1);
  const double yd = y * factor + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y;
  EXPECT_NEAR(pixel->y(), 0.49 * 1024 * yd + 0.52 * 1024 - 180 - 0.5, 0.1);
  EXPECT_LT(read->depth_error_px, 0.15);
  EXPECT_LT(read->color_error_px, 0.7);
  EXPECT_NEAR(read->cameras.color_from_depth.translation_m.x(), -0.032, 1e-9);
  EXPECT_EQ(read->cameras.color.height, 720);
}

TEST(AzureKinectCalibration, unknown_modes_are_refused) {
  const std::vector<std::uint8_t> json(kAzureCalibration.begin(), kAzureCalibration.end());
  EXPECT_EQ(read_azure_kinect_calibration(json, "PASSIVE_IR", 720).error().code,
            ErrorCode::kUnsupported);
  EXPECT_EQ(read_azure_kinect_calibration(json, "WFOV_UNBINNED", 99).error().code,
            ErrorCode::kUnsupported);
  EXPECT_TRUE(read_azure_kinect_calibration(json, "WFOV_UNBINNED", 0).ok());
}

/// Real: one Azure Kinect, recorded by k4arecorder. FFmpeg reads its depth in tests/cli.
TEST(AzureKinectFile, reads_a_real_recording) {
  const auto path = shared_data() / "azurekinect_mkv/recording.mkv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const auto file = open_azure_kinect_file(path);
  ASSERT_TRUE(file.ok()) << file.error().message;
  const SensorFileInfo& info = (*file)->info();
  EXPECT_EQ(info.description.name, "001514394512");
  EXPECT_EQ(info.times, std::vector<nanoseconds>{std::chrono::microseconds(800'222)});
  DepthImage depth;
  ColorImage color;
  ASSERT_TRUE((*file)->read_depth(0, depth).ok());
  ASSERT_TRUE((*file)->read_color(0, color).ok());
  EXPECT_EQ(color.width(), 1280);
  std::vector<std::uint16_t> values(depth.data(), depth.data() + depth.view().pixel_count());
  std::erase(values, 0);
  ASSERT_GT(values.size(), 100'000U);
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  EXPECT_GT(values[values.size() / 2], 300);
  EXPECT_LT(values[values.size() / 2], 6000);
}

}  // namespace
}  // namespace roomcast::recording
