// SPDX-License-Identifier: Apache-2.0
#include "bench/align/scene_tally.h"

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

AlignCase pair_of_overlap(double overlap) {
  AlignCase pair;
  pair.overlap = overlap;
  return pair;
}

RigidTransform aside(double metres) {
  RigidTransform pose;
  pose.translation_m.x() = metres;
  return pose;
}

TEST(SceneTally, counts_each_scene_by_overlap_in_the_order_of_the_scenes) {
  SceneTally tally;
  tally.of("office").add(pair_of_overlap(0.5), aside(0.01));
  tally.of("bare").add(pair_of_overlap(0.5), std::nullopt);
  tally.of("office").add(pair_of_overlap(0.5), aside(0.2));
  tally.of("office").add(pair_of_overlap(0.2), std::nullopt);
  const auto rows = tally.rows();
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].scene, "office");
  EXPECT_EQ(rows[0].overlap, "30-60 %");
  EXPECT_EQ(rows[0].pairs, 2);
  EXPECT_EQ(rows[0].right, 1);
  EXPECT_EQ(rows[0].wrong, 1);
  EXPECT_EQ(rows[1].overlap, "10-30 %");
  EXPECT_EQ(rows[1].refused, 1);
  EXPECT_EQ(rows[2].scene, "bare");
  EXPECT_EQ(rows[2].refused, 1);
}

TEST(SceneTally, separates_rooms_of_one_kind_from_other_rooms) {
  SceneTally tally;
  tally.of("bare").add_unanswerable(std::nullopt, Unanswerable::kOtherRooms);
  tally.of("bare").add_unanswerable(aside(1), Unanswerable::kRoomsOfOneKind);
  const auto rows = tally.rows();
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].overlap, "none");
  EXPECT_EQ(rows[0].wrong, 0);
  EXPECT_EQ(rows[1].overlap, "alike");
  EXPECT_EQ(rows[1].wrong, 1);
}

}  // namespace
}  // namespace roomcast::bench
