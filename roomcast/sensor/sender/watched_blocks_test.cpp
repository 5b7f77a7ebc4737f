// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/sender/watched_blocks.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::sensor {
namespace {

using codec::BlockNeed;

constexpr int kWatchedWidth = 160, kWatchedHeight = 120;
constexpr int kColumns = codec::need_blocks(kWatchedWidth);
constexpr int kRows = codec::need_blocks(kWatchedHeight);
constexpr int kSecondOfFrames = 16;

CameraIntrinsics watched_lens() {
  return {.width = kWatchedWidth,
          .height = kWatchedHeight,
          .fx = 120,
          .fy = 120,
          .cx = 79.5,
          .cy = 59.5};
}

DepthImage wall(int z_mm = 3000) {
  return DepthImage(kWatchedWidth, kWatchedHeight, static_cast<std::uint16_t>(z_mm));
}

/// A flat thing before the wall.
DepthImage wall_with_board(int left, int right, int z_mm) {
  DepthImage depth = wall();
  for (int y = 24; y < 96; ++y) {
    for (int x = left; x < right; ++x) depth.at(x, y) = static_cast<std::uint16_t>(z_mm);
  }
  return depth;
}

/// From `eye` towards `to`, in the depth frame.
wire::pb::WatchedFrom seen_from(const Eigen::Vector3f& eye, const Eigen::Vector3f& to,
                                float half_angle = 0.3F) {
  wire::pb::WatchedFrom watched;
  wire::pb::ViewCone& cone = *watched.add_cones();
  const Eigen::Vector3f forward = (to - eye).normalized();
  cone.mutable_eye()->set_x(eye.x());
  cone.mutable_eye()->set_y(eye.y());
  cone.mutable_eye()->set_z(eye.z());
  cone.mutable_forward()->set_x(forward.x());
  cone.mutable_forward()->set_y(forward.y());
  cone.mutable_forward()->set_z(forward.z());
  cone.set_half_angle(half_angle);
  return watched;
}

const Eigen::Vector3f kSensor(0, 0, 0), kMiddleOfWall(0, 0, 3), kBehindTheWall(0, 0, 6);

/// The largest need of one block over so many frames.
BlockNeed most(WatchedBlocks& blocks, const DepthImage& now, const DepthImage& shown, int column,
               int row, int frames) {
  BlockNeed need = BlockNeed::kNothing;
  for (int i = 0; i < frames; ++i)
    need = std::max(need, blocks.update(now, shown, 2).at(column, row));
  return need;
}

TEST(WatchedBlocks, everything_is_needed_until_it_is_known_from_where_it_is_seen) {
  WatchedBlocks blocks(watched_lens());
  EXPECT_EQ(blocks.update(wall(), wall(), 2).data, nullptr);
  blocks.watch_from(seen_from(kSensor, kMiddleOfWall));
  EXPECT_NE(blocks.update(wall(), wall(), 2).data, nullptr);
  EXPECT_EQ(blocks.update(wall(), {}, 2).data, nullptr) << "nothing is shown yet";
  blocks.watch_from({});
  EXPECT_EQ(blocks.update(wall(), wall(), 2).data, nullptr);
}

TEST(WatchedBlocks, what_is_in_a_cone_is_needed_and_the_rest_once_a_second) {
  WatchedBlocks blocks(watched_lens());
  blocks.watch_from(seen_from(kSensor, kMiddleOfWall));
  int corner_needed = 0;
  for (int i = 0; i < 4 * kSecondOfFrames; ++i) {
    const auto needs = blocks.update(wall(), wall(), 2);
    ASSERT_EQ(needs.width, kColumns);
    ASSERT_EQ(needs.height, kRows);
    EXPECT_EQ(needs.at(kColumns / 2, kRows / 2), BlockNeed::kAll);
    EXPECT_NE(needs.at(0, 0), BlockNeed::kAll);
    corner_needed += needs.at(0, 0) != BlockNeed::kNothing;
  }
  EXPECT_GE(corner_needed, 4);
  EXPECT_LE(corner_needed, 4 * 2) << "a turn lasts until a frame of layer 0 has come";
}

TEST(WatchedBlocks, above_a_wide_picture_less_is_needed) {
  WatchedBlocks blocks(watched_lens());
  auto watched = seen_from(kSensor, kMiddleOfWall, 0.6F);
  blocks.watch_from(watched);
  const int above = 0, middle = kColumns / 2;  // 0.46 rad above the axis
  EXPECT_EQ(blocks.update(wall(), wall(), 2).at(middle, above), BlockNeed::kAll);
  auto& cone = *watched.mutable_cones(0);
  cone.mutable_up()->set_y(-1);
  cone.set_half_width(0.6F);
  cone.set_half_height(0.3F);
  blocks.watch_from(watched);
  EXPECT_NE(blocks.update(wall(), wall(), 2).at(middle, above), BlockNeed::kAll);
  cone.mutable_up()->set_y(0);
  cone.mutable_up()->set_x(1);  // the viewer lies on the side
  blocks.watch_from(watched);
  EXPECT_EQ(blocks.update(wall(), wall(), 2).at(middle, above), BlockNeed::kAll);
}

TEST(WatchedBlocks, colour_outside_comes_every_fourth_time) {
  WatchedBlocks blocks(watched_lens());
  blocks.watch_from(seen_from(kSensor, kMiddleOfWall));
  int depth = 0, color = 0;
  for (int i = 0; i < 16 * kSecondOfFrames; ++i) {
    const BlockNeed need = blocks.update(wall(), wall(), 2).at(0, 0);
    depth += need != BlockNeed::kNothing;
    color += need >= BlockNeed::kBaseOnly;
  }
  EXPECT_EQ(depth, 4 * color);
}

TEST(WatchedBlocks, turns_are_spread_over_the_frames) {
  WatchedBlocks blocks(watched_lens());
  blocks.watch_from(seen_from(kSensor, {0, 0, -3}));
  for (int i = 0; i < 2 * kSecondOfFrames; ++i) {
    const auto needs = blocks.update(wall(), wall(), 2);
    int needed = 0;
    for (std::size_t k = 0; k < needs.pixel_count(); ++k)
      needed += needs.data[k] != BlockNeed::kNothing;
    EXPECT_LE(needed, kColumns * 2);
  }
}

TEST(WatchedBlocks, a_surface_that_faces_away_is_needed_now_and_then) {
  WatchedBlocks blocks(watched_lens());
  blocks.watch_from(seen_from(kBehindTheWall, kMiddleOfWall));
  int needed = 0;
  for (int i = 0; i < 4 * kSecondOfFrames; ++i) {
    const BlockNeed need = blocks.update(wall(), wall(), 2).at(kColumns / 2, kRows / 2);
    EXPECT_NE(need, BlockNeed::kAll);
    needed += need != BlockNeed::kNothing;
  }
  EXPECT_GE(needed, 8);
  EXPECT_LE(needed, 4 * kSecondOfFrames / 3);
}

TEST(WatchedBlocks, a_surface_seen_edge_on_is_needed_in_its_base) {
  WatchedBlocks blocks(watched_lens());
  blocks.watch_from(seen_from({2.5F, 0, 2.8F}, kMiddleOfWall));
  EXPECT_EQ(most(blocks, wall(), wall(), kColumns / 2, kRows / 2, 8), BlockNeed::kBaseOnly);
  blocks.watch_from(seen_from({1.5F, 0, 1.5F}, kMiddleOfWall));
  EXPECT_EQ(most(blocks, wall(), wall(), kColumns / 2, kRows / 2, 1), BlockNeed::kAll);
}

TEST(WatchedBlocks, what_is_shown_and_seen_is_needed_wherever_the_new_surface_is) {
  WatchedBlocks blocks(watched_lens());
  // The viewer sees what is near the sensor, not the wall.
  blocks.watch_from(seen_from({0.5F, 0, 0}, {0, 0, 1}, 0.1F));
  const DepthImage with_board = wall_with_board(72, 88, 1000);
  EXPECT_EQ(most(blocks, wall(), wall(), 10, kRows / 2, 1), BlockNeed::kNothing);
  EXPECT_EQ(most(blocks, with_board, wall(), 10, kRows / 2, 1), BlockNeed::kAll) << "it comes";
  EXPECT_EQ(most(blocks, wall(), with_board, 10, kRows / 2, 1), BlockNeed::kAll) << "it goes";
}

TEST(WatchedBlocks, a_back_that_has_gone_does_not_stay_before_the_viewer) {
  // He looks at the back of the board, and at nothing behind it: the sensor is not in his view.
  WatchedBlocks blocks(watched_lens());
  blocks.watch_from(seen_from({0.2F, 0, 2}, {0, 0, 1.0F}, 0.3F));
  const DepthImage with_board = wall_with_board(64, 96, 1000);
  for (int i = 0; i < 8; ++i) {
    const auto gone = blocks.update(wall(), with_board, 2).at(10, kRows / 2);
    EXPECT_GE(gone, BlockNeed::kShapeOnly);
  }
}

TEST(WatchedBlocks, unknown_depth_is_needed_unless_nothing_beside_it_is) {
  WatchedBlocks blocks(watched_lens());
  blocks.watch_from(seen_from(kSensor, {0, 0, -3}));
  DepthImage hole = wall();
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 24; ++x) hole.at(x, y) = 0;
  }
  const auto needs = blocks.update(hole, hole, 2);
  EXPECT_EQ(needs.at(0, 0), BlockNeed::kAll);
  EXPECT_NE(needs.at(2, 2), BlockNeed::kAll);
  EXPECT_NE(needs.at(4, 4), BlockNeed::kAll);
}

TEST(WatchedBlocks, what_one_of_several_viewers_sees_is_needed) {
  WatchedBlocks blocks(watched_lens());
  wire::pb::WatchedFrom both = seen_from(kSensor, {0, 0, -3});
  *both.add_cones() = seen_from(kSensor, {-1.5F, -1, 3}).cones(0);
  blocks.watch_from(both);
  const auto needs = blocks.update(wall(), wall(), 2);
  EXPECT_EQ(needs.at(2, 2), BlockNeed::kAll);
  EXPECT_NE(needs.at(kColumns - 2, kRows - 2), BlockNeed::kAll);
}

TEST(WatchedBlocks, a_viewer_who_sees_all_around_sees_everything_that_faces_him) {
  WatchedBlocks blocks(watched_lens());
  blocks.watch_from(seen_from({0, 0, 1}, {0, 0, -3}, 3.1415F));
  const auto needs = blocks.update(wall(), wall(), 2);
  EXPECT_EQ(needs.at(kColumns / 2, kRows / 2), BlockNeed::kAll);
  EXPECT_NE(needs.at(0, 0), BlockNeed::kNothing);
}

}  // namespace
}  // namespace roomcast::sensor
