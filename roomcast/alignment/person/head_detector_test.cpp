// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/person/head_detector.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"

namespace roomcast::alignment {
namespace {

/// A body and a head, `tall_m` high in all.
void add_person(RoomFixture& room, double x, double z, double tall_m = 1.8) {
  room.boxes.push_back(
      {Eigen::Vector3d(x - 0.22, 0, z - 0.15), Eigen::Vector3d(x + 0.22, tall_m - 0.25, z + 0.15)});
  room.boxes.push_back({Eigen::Vector3d(x - 0.08, tall_m - 0.25, z - 0.08),
                        Eigen::Vector3d(x + 0.08, tall_m, z + 0.08)});
}

class HeadDetectorTest : public testing::Test {
 protected:
  HeadDetectorTest() : bundle_(bundle_fixture({}, "s0", stand_)), floor_(floor_of(bundle_)) {
    if (floor_) finder_.emplace(bundle_, *floor_);
  }

  /// Heads in the world.
  std::vector<Eigen::Vector3d> heads_in(const RoomFixture& room) {
    const auto depth_mm = depth_fixture(room, bundle_.calibration.depth, stand_);
    std::vector<Eigen::Vector3d> heads;
    for (const auto& head : finder_->find(depth_mm.view()))
      heads.push_back(stand_ * head.cast<double>());
    return heads;
  }

  RigidTransform stand_ = world_from_optical_looking_at({2, 1.9, 1.5}, {-0.6, 1.0, -0.3});
  CalibrationBundle bundle_;
  std::optional<Plane> floor_;
  std::optional<HeadDetector> finder_;
};

TEST_F(HeadDetectorTest, the_level_frame_stands_on_the_floor_below_the_sensor) {
  ASSERT_TRUE(floor_);
  const RigidTransform level = level_from_depth(*floor_);
  EXPECT_NEAR(level.translation_m.x(), 0, 1e-9);
  EXPECT_NEAR(level.translation_m.y(), 1.9, 0.02);
  EXPECT_NEAR(level.translation_m.z(), 0, 1e-9);
  EXPECT_LT((level * Eigen::Vector3d(0, 0, 1)).z(), 0) << "it looks along -z";
}

TEST_F(HeadDetectorTest, an_empty_room_has_no_heads) {
  EXPECT_TRUE(heads_in({}).empty());
}

TEST_F(HeadDetectorTest, a_persons_head_is_found) {
  RoomFixture room;
  add_person(room, -0.8, 0.9);
  const auto heads = heads_in(room);
  ASSERT_EQ(heads.size(), 1U);
  EXPECT_NEAR(heads[0].x(), -0.8, 0.09) << "the side towards the sensor is seen";
  EXPECT_NEAR(heads[0].z(), 0.9, 0.09);
  EXPECT_NEAR(heads[0].y(), 1.7, 0.1);
}

TEST_F(HeadDetectorTest, a_head_beyond_the_picture_is_not_invented) {
  RoomFixture room;
  add_person(room, 1.5, 1.15, 2.15);
  EXPECT_TRUE(heads_in(room).empty()) << "its head is at the upper border";
}

TEST_F(HeadDetectorTest, two_people_have_two_heads) {
  RoomFixture room;
  add_person(room, -0.8, 1.0);
  add_person(room, 0.2, -1.1, 1.6);
  EXPECT_EQ(heads_in(room).size(), 2U);
}

TEST_F(HeadDetectorTest, a_chair_that_was_put_there_has_none) {
  RoomFixture room;
  room.boxes.push_back({Eigen::Vector3d(-1, 0, 0.8), Eigen::Vector3d(-0.5, 0.9, 1.3)});
  EXPECT_TRUE(heads_in(room).empty());
}

TEST_F(HeadDetectorTest, furniture_that_was_taken_away_has_none) {
  RoomFixture room;
  room.boxes.erase(room.boxes.begin());
  EXPECT_TRUE(heads_in(room).empty());
}

}  // namespace
}  // namespace roomcast::alignment
