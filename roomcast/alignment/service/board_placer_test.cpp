// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/board_placer.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/service/board_fixture.h"

namespace roomcast::alignment {
namespace {

const RigidTransform kLeftOfBoard = world_from_optical_looking_at({-2.5, 2, 0}, {0, 1, 0});
const RigidTransform kRightOfBoard = world_from_optical_looking_at({2.4, 1.8, 0.5}, {0, 1, 0});

TEST(BoardPlacer, a_lost_sensor_is_placed_beside_one_that_is_not) {
  BoardPlacer placing;
  placing.see("left", held_tag(kLeftOfBoard));
  placing.see("right", held_tag(kRightOfBoard));
  const auto found = placing.place({{"left", kLeftOfBoard}}, {"right", "third"}, {});
  ASSERT_EQ(found.size(), 1U);
  ASSERT_TRUE(found[0].pose.is_placed()) << found[0].pose.note;
  EXPECT_LT((found[0].pose.world_from_depth.translation_m - kRightOfBoard.translation_m).norm(),
            0.01);
}

TEST(BoardPlacer, where_nobody_is_placed_the_first_beside_whom_another_can_be_makes_the_world) {
  BoardPlacer placing;
  placing.see("left", held_tag(kLeftOfBoard));
  placing.see("right", held_tag(kRightOfBoard));
  const Seeds seeds = {{"blind", {}}, {"left", kLeftOfBoard}, {"right", kRightOfBoard}};
  const auto found = placing.place({}, {"blind", "left", "right"}, seeds);
  ASSERT_EQ(found.size(), 2U);
  ASSERT_TRUE(found[0].pose.is_placed() && found[1].pose.is_placed());
  EXPECT_EQ(found[0].sensor, "right");
  EXPECT_LT((found[0].pose.world_from_depth.translation_m - kRightOfBoard.translation_m).norm(),
            0.01);
  EXPECT_EQ(found[1].sensor, "left");
  EXPECT_EQ(found[1].pose.world_from_depth.translation_m, kLeftOfBoard.translation_m);
}

TEST(BoardPlacer, alone_nobody_makes_a_world) {
  BoardPlacer placing;
  placing.see("left", held_tag(kLeftOfBoard));
  for (const auto& placement : placing.place({}, {"left", "right"}, {{"left", kLeftOfBoard}}))
    EXPECT_FALSE(placement.pose.is_placed());
}

TEST(BoardPlacer, whom_a_board_has_placed_others_are_placed_beside) {
  const RigidTransform first = world_from_optical_looking_at({0, 2, 2.5}, {0, 1, 0});
  const auto later = [](wire::pb::Sightings seen) {
    for (auto& tag : *seen.mutable_tags()) tag.set_room_ns(tag.room_ns() + 60'000'000'000ULL);
    return seen;
  };
  BoardPlacer placing;
  placing.see("left", held_tag(kLeftOfBoard));  // with "right" first, then with "a"
  placing.see("right", held_tag(kRightOfBoard));
  placing.see("left", later(held_tag(kLeftOfBoard)));
  placing.see("a", later(held_tag(first)));
  const auto found = placing.place({{"right", kRightOfBoard}}, {"a", "left"}, {});
  ASSERT_EQ(found.size(), 2U);
  ASSERT_TRUE(found[0].pose.is_placed()) << found[0].pose.note;
  EXPECT_LT((found[0].pose.world_from_depth.translation_m - first.translation_m).norm(), 0.02);
}

TEST(BoardPlacer, what_was_seen_before_it_was_moved_does_not_count) {
  BoardPlacer placing;
  placing.see("left", held_tag(kLeftOfBoard));
  placing.see("right", held_tag(kRightOfBoard));
  placing.forget("right");
  EXPECT_TRUE(placing.place({{"left", kLeftOfBoard}}, {"right"}, {}).empty());
}

TEST(BoardPlacer, a_board_that_only_the_lost_sensor_saw_gives_a_reason) {
  BoardPlacer placing;
  placing.see("left", {});
  auto elsewhen = held_tag(kLeftOfBoard);
  for (auto& tag : *elsewhen.mutable_tags()) tag.set_room_ns(tag.room_ns() + 60'000'000'000ULL);
  placing.see("left", elsewhen);
  placing.see("right", held_tag(kRightOfBoard));
  const auto found = placing.place({{"left", kLeftOfBoard}}, {"right"}, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].pose.is_placed());
  EXPECT_FALSE(found[0].pose.note.empty());
}

}  // namespace
}  // namespace roomcast::alignment
