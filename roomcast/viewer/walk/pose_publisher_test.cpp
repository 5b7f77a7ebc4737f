// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/walk/pose_publisher.h"

#include <gtest/gtest.h>

#include "roomcast/viewer/report/host_time_fixture.h"

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

client::PersonPose publisher_pose_at(double x) {
  client::PersonPose pose;
  pose.world_from_head.translation_m = {x, 1.6, 0};
  return pose;
}

TEST(PosePublisher, is_sent_at_most_20_times_a_second_and_the_last_pose_always) {
  PosePublisher own;
  EXPECT_FALSE(own.take(at(0ms)));
  own.set(publisher_pose_at(1));
  EXPECT_TRUE(own.take(at(1ms)));
  own.set(publisher_pose_at(2));
  own.set(publisher_pose_at(3));
  EXPECT_FALSE(own.take(at(20ms)));
  const auto last = own.take(at(51ms));
  ASSERT_TRUE(last);
  EXPECT_EQ(last->world_from_head.translation_m.x(), 3);
  EXPECT_FALSE(own.take(at(200ms))) << "no change, no message";
}

TEST(PosePublisher, is_not_sent_while_it_stays_the_same) {
  PosePublisher own;
  own.set(publisher_pose_at(1));
  EXPECT_TRUE(own.take(at(0ms)));
  own.set(publisher_pose_at(1));
  EXPECT_FALSE(own.take(at(100ms)));
  client::PersonPose pointing = publisher_pose_at(1);
  pointing.pointer = client::PointerBeam{{0, 1, 0}, {0, 1, -1}};
  own.set(pointing);
  EXPECT_TRUE(own.take(at(200ms)));
  own.set(publisher_pose_at(1));
  EXPECT_TRUE(own.take(at(300ms))) << "the end of pointing is a change, too";
}

TEST(PosePublisher, is_sent_again_to_people_who_arrive) {
  PosePublisher own;
  own.set(publisher_pose_at(1));
  EXPECT_TRUE(own.take(at(0ms)));
  own.send_again();
  EXPECT_TRUE(own.take(at(100ms)));
}

}  // namespace
}  // namespace roomcast::viewer
