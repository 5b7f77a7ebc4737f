// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/bundle/bundle_capture.h"

#include <vector>

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

SensorCalibration captured_calibration() {
  SensorCalibration calibration;
  calibration.depth = {16, 12, 12, 12, 7.5, 5.5};
  calibration.color = {8, 6, 6, 6, 3.5, 2.5};
  return calibration;
}

DepthImage captured_depth(std::uint16_t mm = 2000) {
  return {16, 12, mm};
}

/// Stripes of `grey` and 100 levels more.
ColorImage captured_color(std::uint8_t grey) {
  ColorImage color(8, 6, {grey, grey, grey});
  for (int y = 0; y < 6; ++y) {
    const auto bright = static_cast<std::uint8_t>(grey + 100);
    for (int x = 0; x < 8; x += 2) color.at(x, y) = {bright, bright, bright};
  }
  return color;
}

TEST(BundleCapture, has_enough_after_thirty_frames) {
  BundleCapture capture("s0", captured_calibration());
  for (std::size_t i = 1; i < kBundleFrames; ++i)
    EXPECT_FALSE(capture.add(captured_depth(), captured_color(50)).value()) << i;
  EXPECT_TRUE(capture.add(captured_depth(), captured_color(50)).value());
  EXPECT_TRUE(capture.add(captured_depth(), captured_color(50)).value());  // and stays so
}

TEST(BundleCapture, frames_after_the_last_change_nothing) {
  BundleCapture capture("s0", captured_calibration());
  for (std::size_t i = 0; i < kBundleFrames; ++i)
    ASSERT_TRUE(capture.add(captured_depth(), captured_color(50)).ok());
  for (std::size_t i = 0; i < 2 * kBundleFrames; ++i)
    ASSERT_TRUE(capture.add(captured_depth(3000), captured_color(150)).ok());
  const auto bundle = capture.finish();
  ASSERT_TRUE(bundle.ok()) << bundle.error().message;
  EXPECT_EQ(bundle->depth_mm, captured_depth());
  EXPECT_EQ(bundle->color, captured_color(50));
}

TEST(BundleCapture, gives_the_medians_with_name_and_calibration) {
  BundleCapture capture("left", captured_calibration());
  for (const std::uint16_t mm : std::vector<std::uint16_t>{2004, 2000, 2002})
    ASSERT_TRUE(capture.add(captured_depth(mm), captured_color(mm == 2000 ? 60 : 50)).ok());
  const auto bundle = capture.finish();
  ASSERT_TRUE(bundle.ok()) << bundle.error().message;
  EXPECT_EQ(bundle->name, "left");
  EXPECT_EQ(bundle->calibration.depth, captured_calibration().depth);
  EXPECT_EQ(bundle->depth_mm, captured_depth(2002));
  EXPECT_EQ(bundle->color, captured_color(50));
}

TEST(BundleCapture, keeps_colour_pictures_from_all_of_the_time) {
  // Of 30 pictures, each brighter than the one before, every fourth is kept: 0, 4, ... 28. Their
  // median is the upper of both in the middle, 16.
  BundleCapture capture("s0", captured_calibration());
  for (std::size_t i = 0; i < kBundleFrames; ++i)
    ASSERT_TRUE(capture.add(captured_depth(), captured_color(static_cast<std::uint8_t>(i))).ok());
  const auto bundle = capture.finish();
  ASSERT_TRUE(bundle.ok()) << bundle.error().message;
  EXPECT_EQ(bundle->color, captured_color(16));
}

TEST(BundleCapture, frames_without_colour_count) {
  BundleCapture capture("s0", captured_calibration());
  ASSERT_TRUE(capture.add(captured_depth(), {}).ok());
  ASSERT_TRUE(capture.add(captured_depth(), captured_color(50)).ok());
  const auto bundle = capture.finish();
  ASSERT_TRUE(bundle.ok()) << bundle.error().message;
  EXPECT_EQ(bundle->color, captured_color(50));
}

TEST(BundleCapture, refuses_pictures_of_another_size_and_goes_on) {
  BundleCapture capture("left", captured_calibration());
  const auto wrong_depth = capture.add(DepthImage(15, 12, 2000), captured_color(50));
  ASSERT_FALSE(wrong_depth.ok());
  EXPECT_EQ(wrong_depth.error().code, ErrorCode::kInvalidArgument);
  EXPECT_NE(wrong_depth.error().message.find("left"), std::string::npos);
  EXPECT_FALSE(capture.add(captured_depth(), ColorImage(8, 7)).ok());
  EXPECT_EQ(capture.finish().error().code, ErrorCode::kUnavailable);  // neither was added
  ASSERT_TRUE(capture.add(captured_depth(), captured_color(50)).ok());
  EXPECT_TRUE(capture.finish().ok());
}

TEST(BundleCapture, without_frames_or_without_depth_gives_no_bundle) {
  BundleCapture capture("s0", captured_calibration());
  EXPECT_EQ(capture.finish().error().code, ErrorCode::kUnavailable);
  ASSERT_TRUE(capture.add(captured_depth(0), captured_color(50)).ok());
  EXPECT_EQ(capture.finish().error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace roomcast::alignment
