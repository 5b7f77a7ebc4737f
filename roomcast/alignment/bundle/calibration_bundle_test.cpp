// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/bundle/calibration_bundle.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/alignment/bundle/bundle_capture.h"
#include "roomcast/alignment/feature/room_fixture.h"

namespace roomcast::alignment {
namespace {

using testing::HasSubstr;

CalibrationBundle good_bundle() {
  static const CalibrationBundle bundle = bundle_fixture({}, "s1", corner_pose(2, 1.5));
  return bundle;
}

void expect_refused(const CalibrationBundle& bundle, const char* part_of_sentence) {
  const Status status = check(bundle);
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().message, HasSubstr(part_of_sentence));
  EXPECT_THAT(status.error().message, HasSubstr("s1"));
}

TEST(CalibrationBundle, accepts_what_a_sensor_sends) {
  EXPECT_TRUE(check(good_bundle()).ok());
}

TEST(CalibrationBundle, refuses_a_black_picture) {
  CalibrationBundle bundle = good_bundle();
  bundle.color = ColorImage(bundle.color.width(), bundle.color.height());
  expect_refused(bundle, "without contrast");
}

TEST(CalibrationBundle, refuses_depth_without_readings) {
  CalibrationBundle bundle = good_bundle();
  bundle.depth_mm = DepthImage(bundle.depth_mm.width(), bundle.depth_mm.height());
  expect_refused(bundle, "almost no depth");
}

TEST(CalibrationBundle, refuses_intrinsics_that_are_no_numbers) {
  CalibrationBundle bundle = good_bundle();
  bundle.calibration.depth.fx = std::numeric_limits<double>::quiet_NaN();
  expect_refused(bundle, "fx");
}

TEST(CalibrationBundle, refuses_extrinsics_that_are_no_transform) {
  CalibrationBundle bundle = good_bundle();
  bundle.calibration.color_from_depth.rotation(0, 0) = std::numeric_limits<double>::infinity();
  expect_refused(bundle, "color_from_depth");
}

TEST(CalibrationBundle, refuses_pictures_of_no_or_another_size) {
  CalibrationBundle no_color = good_bundle();
  no_color.color = {};
  expect_refused(no_color, "no colour");
  CalibrationBundle no_depth = good_bundle();
  no_depth.depth_mm = {};
  expect_refused(no_depth, "0x0");
  CalibrationBundle other_mask = good_bundle();
  other_mask.moving = MaskImage(3, 3);
  expect_refused(other_mask, "mask");
}

TEST(CalibrationBundle, refuses_gravity_that_is_no_direction) {
  CalibrationBundle bundle = good_bundle();
  bundle.up = Eigen::Vector3d(0, -9.81, 0);
  expect_refused(bundle, "gravity");
}

TEST(BundleCapture, gives_the_steady_pictures_of_what_it_saw) {
  const CalibrationBundle seen = good_bundle();
  BundleCapture capture("s1", seen.calibration);
  std::size_t frames = 0;
  for (bool enough = false; !enough; ++frames) {
    const auto added = capture.add(seen.depth_mm, seen.color);
    ASSERT_TRUE(added.ok());
    enough = *added;
  }
  EXPECT_EQ(frames, kBundleFrames);
  const auto bundle = capture.finish();
  ASSERT_TRUE(bundle.ok());
  EXPECT_EQ(bundle->depth_mm, seen.depth_mm);
  EXPECT_EQ(bundle->color, seen.color);
}

/// The colour of a bundle of `frames` frames, in some of which a person is in the way.
template <class InTheWay>
ColorImage color_of(std::size_t frames, InTheWay in_the_way) {
  const CalibrationBundle seen = good_bundle();
  BundleCapture capture("s1", seen.calibration);
  for (std::size_t i = 0; i < frames; ++i) {
    ColorImage color = seen.color;
    if (in_the_way(i)) color.at(200, 150) = {200, 10, 10};
    EXPECT_TRUE(capture.add(seen.depth_mm, color).ok());
  }
  return capture.finish()->color;
}

TEST(BundleCapture, whoever_is_in_few_of_few_frames_is_not_in_its_colour) {
  EXPECT_EQ(color_of(3, [](std::size_t i) { return i == 0; }), good_bundle().color);
  EXPECT_EQ(color_of(12, [](std::size_t i) { return i < 4; }), good_bundle().color);
}

TEST(BundleCapture, colour_is_of_all_the_time_that_it_watched) {
  EXPECT_EQ(color_of(kBundleFrames, [](std::size_t i) { return i < 10; }), good_bundle().color);
  EXPECT_EQ(color_of(kBundleFrames, [](std::size_t i) { return i >= 20; }), good_bundle().color);
  EXPECT_NE(color_of(kBundleFrames, [](std::size_t i) { return i >= 10; }), good_bundle().color);
}

TEST(BundleCapture, has_nothing_to_give_before_the_first_frame) {
  EXPECT_EQ(BundleCapture("s1", calibration_fixture()).finish().error().code,
            ErrorCode::kUnavailable);
}

TEST(BundleCapture, refuses_frames_of_another_size) {
  BundleCapture capture("s1", calibration_fixture());
  EXPECT_FALSE(capture.add(DepthImage(2, 2), {}).ok());
  EXPECT_FALSE(capture.add(good_bundle().depth_mm, ColorImage(2, 2)).ok());
}

}  // namespace
}  // namespace roomcast::alignment
