// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/board_bearer.h"

#include <gtest/gtest.h>

#include "roomcast/simulator/people/performance.h"

namespace roomcast::simulator {
namespace {

TEST(BoardBearer, one_person_carries_the_board_through_the_room_and_pauses_with_it) {
  Room room = build_room("livingroom", 1).value();
  ASSERT_TRUE(add_board_bearer(room));
  ASSERT_EQ(room.people.size(), 1U);
  const Performance performance(room.people[0]);
  int still = 0;
  Eigen::AlignedBox3f places;
  for (int i = 0; i < 300; ++i) {
    const auto before = performance.at(0.2 * i), after = performance.at(0.2 * i + 0.1);
    const Eigen::Vector3f at = before.world_from_burden.translation();
    still += (after.world_from_burden.translation() - at).norm() < 0.01F;
    places.extend(at);
  }
  EXPECT_GT(still, 60);
  EXPECT_GT(places.diagonal().norm(), 0.8F);
}

TEST(BoardBearer, a_room_without_a_walking_person_stays_as_it_is) {
  Room room = build_room("livingroom", 1).value();
  room.people.clear();
  EXPECT_FALSE(add_board_bearer(room));
  EXPECT_TRUE(room.people.empty());
}

}  // namespace
}  // namespace roomcast::simulator
