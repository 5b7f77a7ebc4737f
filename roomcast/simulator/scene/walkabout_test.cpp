// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/walkabout.h"

#include <gtest/gtest.h>

#include "roomcast/simulator/people/performance.h"

namespace roomcast::simulator {
namespace {

TEST(Walkabout, one_person_walks_upright_through_the_room_and_keeps_moving) {
  Room room = build_room("livingroom", 1).value();
  ASSERT_TRUE(add_walkabout(room));
  ASSERT_EQ(room.people.size(), 1U);
  const Performance performance(room.people[0]);
  Eigen::AlignedBox3f places;
  double way_m = 0;
  Eigen::Vector3f before;
  for (int i = 0; i <= 200; ++i) {
    const Eigen::Vector3f head = performance.at(0.1 * i).pose.of(Bone::kHead).translation();
    places.extend(head);
    if (i > 0) way_m += double((head - before).norm());
    before = head;
  }
  EXPECT_GT(places.diagonal().norm(), 1.0F);
  EXPECT_GT(way_m, 5) << "in 20 s";
  EXPECT_LT(places.sizes().y(), 0.2F) << "without sitting down or bending";
}

TEST(Walkabout, a_room_without_a_walking_person_stays_as_it_is) {
  Room room = build_room("livingroom", 1).value();
  room.people.clear();
  EXPECT_FALSE(add_walkabout(room));
  EXPECT_TRUE(room.people.empty());
}

}  // namespace
}  // namespace roomcast::simulator
