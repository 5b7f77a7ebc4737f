// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/still_view.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace roomcast::model {
namespace {

const CameraIntrinsics kSmall = {
    .width = 64, .height = 48, .fx = 60, .fy = 60, .cx = 31.5, .cy = 23.5};

StillView small_view() {
  return *StillView::create(kSmall, {});
}

/// A wall at `wall_mm` with noise, and something else in front of it in these columns.
DepthImage wall(double wall_mm, unsigned seed, int from_x = 0, int to_x = 0, double front_mm = 0) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 4);
  DepthImage depth_mm(kSmall.width, kSmall.height);
  for (int y = 0; y < kSmall.height; ++y)
    for (int x = 0; x < kSmall.width; ++x)
      depth_mm.at(x, y) = static_cast<std::uint16_t>(
          std::lround((x >= from_x && x < to_x ? front_mm : wall_mm) + noise(random)));
  return depth_mm;
}

/// Root mean square of the errors.
double error_mm(const StillView& view, double truth_mm, int from_x = 0, int to_x = 64) {
  double sum = 0;
  for (int y = 0; y < kSmall.height; ++y)
    for (int x = from_x; x < to_x; ++x) sum += std::pow(view.depth_mm(x, y) - truth_mm, 2);
  return std::sqrt(sum / (kSmall.height * (to_x - from_x)));
}

TEST(StillView, noise_averages_out) {
  StillView view = small_view();
  for (unsigned i = 0; i < 40; ++i) view.add(wall(2000, i), {}, {});
  EXPECT_LT(error_mm(view, 2000), 1);
  EXPECT_EQ(view.frames(), 40);
}

TEST(StillView, learns_the_noise_of_the_sensor) {
  StillView view = small_view();
  for (unsigned i = 0; i < 20; ++i) view.add(wall(2000, i), {}, {});
  EXPECT_NEAR(view.sigma_mm(2000), 4, 1.5);
}

TEST(StillView, who_walks_through_is_forgotten) {
  StillView view = small_view();
  for (int i = 0; i < 40; ++i)
    view.add(wall(3000, static_cast<unsigned>(i), 2 * i - 20, 2 * i, 1500), {}, {});
  EXPECT_LT(error_mm(view, 3000), 3);
}

TEST(StillView, who_stands_there_at_first_is_forgotten_when_gone) {
  StillView view = small_view();
  for (unsigned i = 0; i < 30; ++i) view.add(wall(3000, i, 20, 40, 1500), {}, {});
  EXPECT_LT(error_mm(view, 1500, 20, 40), 3);
  for (unsigned i = 30; i < 50; ++i) view.add(wall(3000, i), {}, {});
  EXPECT_LT(error_mm(view, 3000), 3);
}

TEST(StillView, furniture_that_was_put_there_is_believed_after_some_seconds) {
  StillView view = small_view();
  for (unsigned i = 0; i < 200; ++i) view.add(wall(3000, i), {}, {});
  for (unsigned i = 0; i < 90; ++i) view.add(wall(3000, i, 20, 40, 2500), {}, {});
  EXPECT_LT(error_mm(view, 3000), 3);
  for (unsigned i = 0; i < 90; ++i) view.add(wall(3000, i, 20, 40, 2500), {}, {});
  EXPECT_LT(error_mm(view, 2500, 20, 40), 3);
}

ModelOptions of_running_room() {
  ModelOptions options;
  options.memory_frames = 9;
  return options;
}

/// A cabinet in these columns, before a wall or `behind`.
constexpr int kCabinetFrom = 20, kCabinetTo = 40;
DepthImage with_cabinet(unsigned seed) {
  return wall(4000, seed, kCabinetFrom, kCabinetTo, 2500);
}

int forgotten(const StillView& view, int from_x = kCabinetFrom, int to_x = kCabinetTo) {
  int pixels = 0;
  for (int y = 0; y < kSmall.height; ++y)
    for (int x = from_x; x < to_x; ++x)
      pixels += view.depth_mm(x, y) < 2300 || view.depth_mm(x, y) > 2700;
  return pixels;
}
constexpr int kCabinetPixels = (kCabinetTo - kCabinetFrom) * 48;

TEST(StillView, who_has_walked_past_before_does_not_delay_that_furniture_is_forgotten) {
  StillView view = *StillView::create(kSmall, {}, of_running_room());
  for (unsigned i = 0; i < 12; ++i) view.add(with_cabinet(i), {}, {});
  for (unsigned i = 12; i < 18; ++i) view.add(wall(800, i), {}, {});
  EXPECT_EQ(forgotten(view), 0);
  for (unsigned i = 18; i < 21; ++i) view.add(wall(4000, i), {}, {});
  EXPECT_EQ(forgotten(view), kCabinetPixels);
}

TEST(StillView, who_walks_past_again_and_again_is_never_believed) {
  StillView view = *StillView::create(kSmall, {}, of_running_room());
  for (unsigned i = 0; i < 60; ++i) view.add(wall(i % 5 == 4 ? 800 : 4000, i), {}, {});
  EXPECT_LT(error_mm(view, 4000), 4);
}

TEST(StillView, furniture_is_forgotten_where_readings_behind_it_differ) {
  StillView view = *StillView::create(kSmall, {}, of_running_room());
  for (unsigned i = 0; i < 12; ++i) view.add(with_cabinet(i), {}, {});
  for (unsigned i = 0; i < 3; ++i)
    view.add(wall(4000, i, kCabinetFrom, kCabinetTo, 5000 + 300 * i), {}, {});
  EXPECT_EQ(forgotten(view), kCabinetPixels);
}

TEST(StillView, furniture_is_forgotten_where_nothing_behind_it_is_read) {
  StillView view = *StillView::create(kSmall, {}, of_running_room());
  for (unsigned i = 0; i < 12; ++i) view.add(with_cabinet(i), {}, {});
  const auto dark_behind = [](unsigned seed) {
    DepthImage depth_mm = wall(4000, seed);
    for (int y = 0; y < kSmall.height; ++y)
      for (int x = kCabinetFrom + 4; x < kCabinetTo; ++x) depth_mm.at(x, y) = 0;
    return depth_mm;
  };
  for (unsigned i = 0; i < 2; ++i) view.add(dark_behind(i), {}, {});
  EXPECT_EQ(forgotten(view), 0);
  view.add(dark_behind(3), {}, {});
  EXPECT_EQ(forgotten(view), kCabinetPixels);
  EXPECT_FALSE(view.is_sure(kCabinetTo - 1, 20));
}

TEST(StillView, what_is_only_not_read_stays_also_beside_furniture_that_went) {
  StillView view = *StillView::create(kSmall, {}, of_running_room());
  // The right half of the cabinet is glossy, and read every third time.
  const auto glossy = [](DepthImage depth_mm, bool is_read) {
    for (int y = 0; y < kSmall.height && !is_read; ++y)
      for (int x = 30; x < kCabinetTo; ++x) depth_mm.at(x, y) = 0;
    return depth_mm;
  };
  for (unsigned i = 0; i < 30; ++i) view.add(glossy(with_cabinet(i), i % 3 == 0), {}, {});
  for (unsigned i = 30; i < 40; ++i) view.add(glossy(with_cabinet(i), false), {}, {});
  EXPECT_EQ(forgotten(view), 0);
  for (unsigned i = 40; i < 43; ++i) view.add(glossy(wall(4000, i), false), {}, {});
  EXPECT_EQ(forgotten(view, 30, kCabinetTo), 0);
  EXPECT_EQ(forgotten(view, kCabinetFrom, 30), kCabinetPixels / 2);
}

TEST(StillView, a_sensor_that_reads_nothing_for_a_while_forgets_nothing) {
  StillView view = *StillView::create(kSmall, {}, of_running_room());
  for (unsigned i = 0; i < 12; ++i) view.add(with_cabinet(i), {}, {});
  for (int i = 0; i < 20; ++i) view.add(DepthImage(64, 48), {}, {});
  EXPECT_EQ(forgotten(view), 0);
  for (unsigned i = 0; i < 3; ++i) view.add(with_cabinet(i), {}, {});
  EXPECT_EQ(forgotten(view), 0);
}

TEST(StillView, color_is_that_of_the_still_surface) {
  StillView view = small_view();
  const ColorImage blue(64, 48, Rgb8{0, 0, 250}), red(64, 48, Rgb8{250, 0, 0});
  for (unsigned i = 0; i < 20; ++i) view.add(wall(3000, i), blue, {});
  for (unsigned i = 0; i < 5; ++i) view.add(wall(3000, i, 0, 64, 1000), red, {});
  EXPECT_EQ(view.color(10, 10), (Rgb8{0, 0, 250}));
}

TEST(StillView, color_that_the_camera_did_not_see_is_not_taken) {
  StillView view = small_view();
  view.add(wall(3000, 1), ColorImage(64, 48, Rgb8{9, 9, 9}), MaskImage(64, 48, 0));
  EXPECT_FALSE(view.has_color(5, 5));
}

TEST(StillView, a_surface_of_one_frame_of_many_is_not_sure) {
  StillView view = small_view();
  DepthImage empty(64, 48);
  view.add(wall(3000, 1), {}, {});
  EXPECT_TRUE(view.is_sure(10, 10));
  for (int i = 0; i < 20; ++i) view.add(empty, {}, {});
  EXPECT_FALSE(view.is_sure(10, 10));
}

TEST(StillView, agrees_until_the_sensor_is_moved) {
  StillView view = small_view();
  for (unsigned i = 0; i < 10; ++i) view.add(wall(3000, i), {}, {});
  EXPECT_TRUE(view.agrees(wall(3000, 50, 0, 20, 1000)));  // somebody is in the way
  EXPECT_FALSE(view.agrees(wall(2500, 50)));
  EXPECT_FALSE(view.agrees(DepthImage(10, 10, 3000)));
}

TEST(StillView, refuses_cameras_and_poses_of_no_room) {
  RigidTransform pose;
  pose.translation_m.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(StillView::create(kSmall, pose));
  pose.translation_m.x() = 1e12;
  EXPECT_FALSE(StillView::create(kSmall, pose));
  EXPECT_FALSE(small_view().set_pose(pose));
  CameraIntrinsics huge = kSmall;
  huge.width = huge.height = kMaxImageSide;
  const auto refused = StillView::create(huge, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kTooLarge);
  CameraIntrinsics broken = kSmall;
  broken.fx = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(StillView::create(broken, {}));
}

}  // namespace
}  // namespace roomcast::model
