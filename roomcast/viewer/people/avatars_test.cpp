// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/people/avatars.h"

#include <gtest/gtest.h>

namespace roomcast::viewer {
namespace {

constexpr ViewerId kSelf{1}, kOther{2};

client::PersonPose pose_at(double x) {
  client::PersonPose pose;
  pose.world_from_head.translation_m = {x, 1.6, 0};
  return pose;
}

client::RoomSnapshot room_with(const client::PersonPose& other, const std::string& name = "Ada") {
  client::RoomSnapshot room;
  room.self = kSelf;
  room.people = {{kSelf, "me", {}, pose_at(9)},
                 {kOther, name, {1, 2, 3}, other},
                 {ViewerId{3}, "has said nothing yet", {}, {}}};
  return room;
}

TEST(Avatars, show_the_other_people_with_a_known_pose) {
  Avatars avatars;
  avatars.follow(room_with(pose_at(1)));
  ASSERT_EQ(avatars.shown().size(), 1U);
  EXPECT_EQ(avatars.shown()[0].name, "Ada");
  EXPECT_EQ(avatars.shown()[0].color, (Rgb8{1, 2, 3}));
  EXPECT_EQ(avatars.shown()[0].shown.world_from_head.translation_m.x(), 1) << "no gliding in";
}

TEST(Avatars, glide_to_the_newest_pose_and_come_to_rest) {
  Avatars avatars;
  avatars.follow(room_with(pose_at(0)));
  EXPECT_FALSE(avatars.advance(0.01));
  avatars.follow(room_with(pose_at(1)));
  EXPECT_TRUE(avatars.advance(0.02));
  const double on_the_way = avatars.shown()[0].shown.world_from_head.translation_m.x();
  EXPECT_GT(on_the_way, 0.1);
  EXPECT_LT(on_the_way, 0.9);
  for (int i = 0; i < 100; ++i) static_cast<void>(avatars.advance(0.02));
  EXPECT_FALSE(avatars.advance(0.02));
  EXPECT_NEAR(avatars.shown()[0].shown.world_from_head.translation_m.x(), 1, 1e-3);
}

TEST(Avatars, hands_and_beams_appear_and_disappear_at_once) {
  Avatars avatars;
  avatars.follow(room_with(pose_at(0)));
  client::PersonPose pointing = pose_at(0);
  pointing.world_from_right_hand = RigidTransform{};
  pointing.pointer = client::PointerBeam{{0, 1, 0}, {0, 1, -2}};
  avatars.follow(room_with(pointing));
  EXPECT_TRUE(avatars.advance(0.001));
  ASSERT_TRUE(avatars.shown()[0].shown.pointer);
  EXPECT_EQ(avatars.shown()[0].shown.pointer->to_m.z(), -2);
  avatars.follow(room_with(pose_at(0)));
  EXPECT_TRUE(avatars.advance(0.001));
  EXPECT_FALSE(avatars.shown()[0].shown.pointer);
}

TEST(Avatars, a_person_without_a_name_gets_a_number) {
  Avatars avatars;
  avatars.follow(room_with(pose_at(0), ""));
  EXPECT_EQ(avatars.shown()[0].name, "viewer 2");
}

TEST(Avatars, a_person_who_left_is_not_shown) {
  Avatars avatars;
  avatars.follow(room_with(pose_at(0)));
  avatars.follow(client::RoomSnapshot{});
  EXPECT_TRUE(avatars.shown().empty());
}

}  // namespace
}  // namespace roomcast::viewer
