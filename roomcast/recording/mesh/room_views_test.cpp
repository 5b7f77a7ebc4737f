// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mesh/room_views.h"

#include <limits>

#include <gtest/gtest.h>

#include "roomcast/recording/export/wall_fixture.h"

namespace roomcast::recording {
namespace {

/// The n-th set of the wall, with other times than the one before.
FrameSet set_of(int number) {
  FrameSet set = wall_set();
  for (SetFrame& frame : set.frames) frame.time = std::chrono::milliseconds(33 * number);
  return set;
}

void put_depth(SetFrame& frame, std::uint16_t depth_mm) {
  auto pictures = std::make_shared<codec::DecodedFrame>(*frame.pictures);
  pictures->depth_mm = DepthImage(64, 48, depth_mm);
  frame.pictures = std::move(pictures);
}

TEST(RoomViews, each_sensor_has_a_view) {
  RoomViews views(wall_sensors(), {});
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(views.add(set_of(i)));
  EXPECT_EQ(views.views(), 2u);
  EXPECT_EQ(views.frames(), 10u);
  EXPECT_EQ(views.take_surfaces().size(), 2u);
  EXPECT_EQ(views.views(), 0u);
}

TEST(RoomViews, a_frame_that_a_set_repeats_counts_once) {
  RoomViews views(wall_sensors(), {});
  ASSERT_TRUE(views.add(set_of(1)));
  ASSERT_TRUE(views.add(set_of(1)));
  EXPECT_EQ(views.frames(), 2u);
}

TEST(RoomViews, a_sensor_that_was_moved_begins_another_view) {
  RoomViews views(wall_sensors(), {});
  ASSERT_TRUE(views.add(set_of(0)));
  FrameSet moved = set_of(1);
  moved.frames[0].world_from_depth->translation_m.z() += 0.5;
  put_depth(moved.frames[0], 2500);
  ASSERT_TRUE(views.add(moved));
  EXPECT_EQ(views.views(), 3u);
}

TEST(RoomViews, a_pose_that_is_known_better_is_no_move) {
  RoomViews views(wall_sensors(), {});
  ASSERT_TRUE(views.add(set_of(0)));
  FrameSet refined = set_of(1);
  refined.frames[0].world_from_depth->translation_m.z() += 0.02;
  ASSERT_TRUE(views.add(refined));
  EXPECT_EQ(views.views(), 2u);
}

TEST(RoomViews, frames_of_a_sensor_that_was_pushed_are_left_out) {
  RoomViews views(wall_sensors(), {});
  ASSERT_TRUE(views.add(set_of(0)));
  FrameSet pushed = set_of(1);
  put_depth(pushed.frames[0], 1000);
  ASSERT_TRUE(views.add(pushed));
  EXPECT_EQ(views.frames(), 3u);
}

TEST(RoomViews, sensors_without_a_pose_are_left_out) {
  RoomViews views(wall_sensors(), {});
  FrameSet set = set_of(0);
  set.frames[1].world_from_depth.reset();
  ASSERT_TRUE(views.add(set));
  EXPECT_EQ(views.views(), 1u);
}

TEST(RoomViews, one_sensor_needs_no_pose_while_it_stands_still) {
  RoomViews views({wall_sensors()[0]}, {});
  FrameSet set = set_of(0);
  set.frames.resize(1);
  set.frames[0].world_from_depth.reset();
  ASSERT_TRUE(views.add(set));
  EXPECT_EQ(views.views(), 1u);
  put_depth(set.frames[0], 900);
  set.frames[0].time = std::chrono::seconds(1);
  const auto refused = views.add(set);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("it moves"), std::string::npos);
}

TEST(RoomViews, a_pose_without_sense_is_refused_with_the_name_of_the_sensor) {
  RoomViews views(wall_sensors(), {});
  FrameSet set = set_of(0);
  set.frames[1].world_from_depth->translation_m.x() = std::numeric_limits<double>::infinity();
  const auto refused = views.add(set);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("far"), std::string::npos);
}

TEST(RoomViews, memory_is_bounded_and_the_shortest_views_are_given_up) {
  std::vector<SetSensor> sensors = wall_sensors();
  sensors[0].depth.width = sensors[0].depth.height = 2000;
  RoomViews views({sensors[0]}, {});
  FrameSet set = set_of(0);
  set.frames.resize(1);
  for (int i = 0; i < 5; ++i) {
    auto pictures = std::make_shared<codec::DecodedFrame>();
    pictures->depth_mm = DepthImage(2000, 2000, static_cast<std::uint16_t>(1000 + 200 * i));
    set.frames[0].pictures = pictures;
    set.frames[0].world_from_depth->translation_m.x() = i;
    set.frames[0].time = std::chrono::seconds(i);
    ASSERT_TRUE(views.add(set));
  }
  EXPECT_EQ(views.views(), kMaxPixelsOfViews / 4'000'000);
}

}  // namespace
}  // namespace roomcast::recording
