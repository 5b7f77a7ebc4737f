// SPDX-License-Identifier: Apache-2.0
#include "roomcast/aligner/board_placing.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace roomcast::aligner {
namespace {

const RigidTransform kLeft = world_from_optical_looking_at({-2.5, 2, 0}, {0, 1, 0});
const RigidTransform kRight = world_from_optical_looking_at({2.4, 1.8, 0.5}, {0, 1, 0});

/// A tag held for a second at each of six places.
wire::pb::Sightings held_tag(const RigidTransform& world_from_sensor) {
  wire::pb::Sightings seen;
  for (unsigned i = 0; i < 60; ++i) {
    const unsigned place = i / 10;
    RigidTransform world_from_board;
    world_from_board.rotation =
        Eigen::AngleAxisd(0.4 * place, Eigen::Vector3d::UnitY()).toRotationMatrix();
    world_from_board.translation_m = {0.5 * (place % 3) - 0.5, 1 + 0.3 * (place % 2),
                                      0.4 * (place / 3)};
    auto& tag = *seen.add_tags();
    tag.set_room_ns(1'000'000'000'000ULL + 100'000'000ULL * i);
    for (int corner = 0; corner < 4; ++corner) {
      const Eigen::Vector3d printed(corner == 0 || corner == 3 ? -0.08 : 0.08,
                                    corner < 2 ? -0.08 : 0.08, 0);
      const Eigen::Vector3d at = world_from_sensor.inverse() * (world_from_board * printed);
      for (const double metres : at) tag.add_corners(static_cast<float>(metres));
    }
  }
  return seen;
}

TEST(BoardPlacing, a_lost_sensor_is_placed_beside_one_that_is_not) {
  BoardPlacing placing;
  placing.see("left", held_tag(kLeft));
  placing.see("right", held_tag(kRight));
  const auto found = placing.place({{"left", kLeft}}, {"right", "third"});
  ASSERT_EQ(found.size(), 1U);
  ASSERT_TRUE(found[0].world_from_depth) << found[0].note;
  EXPECT_LT((found[0].world_from_depth->translation_m - kRight.translation_m).norm(), 0.01);
}

TEST(BoardPlacing, what_was_seen_before_it_was_moved_does_not_count) {
  BoardPlacing placing;
  placing.see("left", held_tag(kLeft));
  placing.see("right", held_tag(kRight));
  placing.forget("right");
  EXPECT_TRUE(placing.place({{"left", kLeft}}, {"right"}).empty());
}

TEST(BoardPlacing, a_board_that_only_the_lost_sensor_saw_gives_a_reason) {
  BoardPlacing placing;
  placing.see("left", {});
  auto elsewhen = held_tag(kLeft);
  for (auto& tag : *elsewhen.mutable_tags()) tag.set_room_ns(tag.room_ns() + 60'000'000'000ULL);
  placing.see("left", elsewhen);
  placing.see("right", held_tag(kRight));
  const auto found = placing.place({{"left", kLeft}}, {"right"});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].world_from_depth);
  EXPECT_FALSE(found[0].note.empty());
}

}  // namespace
}  // namespace roomcast::aligner
