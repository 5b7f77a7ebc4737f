// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/pose_relay.h"

#include <algorithm>
#include <map>
#include <ranges>

#include <gtest/gtest.h>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;

RoomTime relayed_at(nanoseconds since_start) {
  return RoomTime(1h + since_start);
}

wire::pb::ViewerPose viewer_pose_at(float x) {
  wire::pb::ViewerPose pose;
  pose.set_viewer_id(12345);  // a forged ID; the hub replaces it
  pose.mutable_head()->set_x(x);
  return pose;
}

TEST(PoseRelay, the_newest_pose_goes_out_under_the_viewers_id_at_most_20_times_a_second) {
  PoseRelay relay;
  EXPECT_FALSE(relay.next());
  relay.set(ViewerId{1}, viewer_pose_at(1), relayed_at(10ms));
  relay.set(ViewerId{1}, viewer_pose_at(2), relayed_at(20ms));
  const auto message = relay.take(relayed_at(30ms));
  ASSERT_TRUE(message);
  ASSERT_EQ(message->viewer_poses().poses_size(), 1);
  EXPECT_EQ(message->viewer_poses().poses(0).viewer_id(), 1U);
  EXPECT_EQ(message->viewer_poses().poses(0).head().x(), 2);
  EXPECT_FALSE(relay.next());
  relay.set(ViewerId{1}, viewer_pose_at(3), relayed_at(40ms));
  EXPECT_FALSE(relay.take(relayed_at(41ms)));
  EXPECT_EQ(relay.next(), relayed_at(80ms));
  EXPECT_TRUE(relay.take(relayed_at(80ms)));
}

TEST(PoseRelay, a_new_client_gets_all_poses) {
  PoseRelay relay;
  relay.set(ViewerId{1}, viewer_pose_at(1), relayed_at(0ms));
  EXPECT_TRUE(relay.take(relayed_at(0ms)));
  relay.resend_all();
  const auto message = relay.take(relayed_at(1s));
  ASSERT_TRUE(message);
  EXPECT_EQ(message->viewer_poses().poses_size(), 1);
}

TEST(PoseRelay, more_poses_than_a_message_may_have_follow_in_turns) {
  constexpr auto kViewers = std::uint32_t{wire::kMaxPosesPerMessage} + 100;
  PoseRelay relay;
  const auto all_move = [&](nanoseconds when) {
    for (std::uint32_t i = 1; i <= kViewers; ++i)
      relay.set(ViewerId{i}, viewer_pose_at(1), relayed_at(when));
  };
  std::map<std::uint32_t, int> sent;
  nanoseconds now{};
  for (int message = 0; message < 6; ++message) {
    all_move(now);
    const auto poses = relay.take(relayed_at(now));
    ASSERT_TRUE(poses);
    EXPECT_EQ(poses->viewer_poses().poses_size(), wire::kMaxPosesPerMessage);
    for (const auto& pose : poses->viewer_poses().poses()) ++sent[pose.viewer_id()];
    ASSERT_TRUE(relay.next()) << "there are more";
    now = *relay.next() - relayed_at(0ms);
  }
  EXPECT_EQ(sent.size(), kViewers);
  const auto [least, most] = std::ranges::minmax(sent | std::views::values);
  EXPECT_LE(most - least, 1) << "everybody has a turn";
}

TEST(PoseRelay, many_moving_viewers_lengthen_the_interval) {
  constexpr int kMany = 40;
  PoseRelay relay;
  const auto all_move = [&](nanoseconds when) {
    for (std::uint32_t i = 0; i < kMany; ++i)
      relay.set(ViewerId{i}, viewer_pose_at(1), relayed_at(when));
  };
  all_move(0ms);
  EXPECT_TRUE(relay.take(relayed_at(0ms)));
  all_move(10ms);
  EXPECT_EQ(relay.next(), relayed_at(kMany * wire::kIntervalPerPose));
}

TEST(PoseRelay, poses_of_a_chatterbox_are_dropped) {
  PoseRelay relay;
  for (int i = 0; i < 2 * wire::kMaxPosesPerSecond; ++i) {
    relay.set(ViewerId{1}, viewer_pose_at(static_cast<float>(i)), relayed_at(i * 1ms));
  }
  EXPECT_EQ(relay.take(relayed_at(500ms))->viewer_poses().poses(0).head().x(),
            wire::kMaxPosesPerSecond - 1);
}

TEST(PoseRelay, poses_of_viewers_who_left_are_not_sent) {
  PoseRelay relay;
  relay.set(ViewerId{1}, viewer_pose_at(1), relayed_at(0ms));
  relay.forget(ViewerId{1});
  EXPECT_FALSE(relay.take(relayed_at(1s)));
}

}  // namespace
}  // namespace roomcast::hub
