// SPDX-License-Identifier: Apache-2.0
// When a Room asks its sensors for frames.
#include "roomcast/hub/room/room_test_fixture.h"

namespace roomcast::hub {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::vector<SendControl> demands(const RoomActions& actions) {
  return messages(actions, pb::Control::kFrameDemand);
}

bool wanted(const SendControl& demand) {
  return demand.message.frame_demand().wanted();
}

TEST_F(RoomTest, a_sensor_that_nobody_watches_is_told_so) {
  const auto sensor = enter(sensor_join("left"));
  ASSERT_EQ(demands(actions).size(), 1U);
  EXPECT_THAT(demands(actions)[0].to, ElementsAre(sensor));
  EXPECT_FALSE(wanted(demands(actions)[0]));
  EXPECT_FALSE(room.stats().frames_wanted);
}

TEST_F(RoomTest, a_sensor_of_a_watched_room_is_told_nothing) {
  enter(viewer_join());
  enter(sensor_join("left"), 1s);
  EXPECT_THAT(demands(actions), IsEmpty()) << "frames are wanted unless the hub says otherwise";
  EXPECT_TRUE(room.stats().frames_wanted);
}

TEST_F(RoomTest, all_sensors_send_from_the_first_viewer_until_some_seconds_after_the_last) {
  const auto left = enter(sensor_join("left")), right = enter(sensor_join("right"));
  const auto viewer = enter(viewer_join(), 1s);
  ASSERT_EQ(demands(actions).size(), 1U);
  EXPECT_THAT(demands(actions)[0].to, UnorderedElementsAre(left, right));
  EXPECT_TRUE(wanted(demands(actions)[0]));
  const auto second = enter(viewer_join(), 2s);
  EXPECT_THAT(demands(actions), IsEmpty());
  EXPECT_THAT(demands(room.leave(viewer, at(3s))), IsEmpty());
  EXPECT_THAT(demands(room.leave(second, at(4s))), IsEmpty());
  EXPECT_LE(*room.next_tick(), at(4s + FrameDemand::kKeptUnwatched));
  EXPECT_THAT(demands(room.tick(at(4s + FrameDemand::kKeptUnwatched - 1ms))), IsEmpty());
  const auto ended = demands(room.tick(at(4s + FrameDemand::kKeptUnwatched)));
  ASSERT_EQ(ended.size(), 1U);
  EXPECT_THAT(ended[0].to, UnorderedElementsAre(left, right));
  EXPECT_FALSE(wanted(ended[0]));
}

TEST_F(RoomTest, viewers_of_other_hubs_count) {
  const auto sensor = enter(sensor_join("left"));
  const auto begun = demands(room.watch_elsewhere(true, at(1s)));
  ASSERT_EQ(begun.size(), 1U);
  EXPECT_THAT(begun[0].to, ElementsAre(sensor));
  EXPECT_TRUE(wanted(begun[0]));
  (void)room.watch_elsewhere(false, at(2s));
  EXPECT_EQ(demands(room.tick(at(2s + FrameDemand::kKeptUnwatched))).size(), 1U);
}

TEST_F(RoomTest, sensors_of_other_hubs_are_left_to_these) {
  enter(sensor_join("left"), 0s, {.other_hub = 7});
  EXPECT_THAT(demands(actions), IsEmpty());
  enter(viewer_join(), 1s);
  EXPECT_THAT(demands(actions), IsEmpty());
}

TEST_F(RoomTest, the_owner_may_want_frames_always) {
  enter(sensor_join("left"));
  const auto begun = demands(room.change({.name = "lab", .stream_unwatched = true}, at(1s)));
  ASSERT_EQ(begun.size(), 1U);
  EXPECT_TRUE(wanted(begun[0]));
  enter(sensor_join("right"), 2s);
  EXPECT_THAT(demands(actions), IsEmpty());
}

pb::Join sensor_that_follows(const std::string& name) {
  pb::Join join = sensor_join(name);
  join.mutable_sensor()->set_follows_rate(true);
  return join;
}

TEST_F(RoomTest, the_rooms_uplink_is_shared_by_the_sensors_that_keep_to_it) {
  enter(viewer_join());
  enter(sensor_that_follows("left"));
  enter(sensor_join("of its own mind"));
  EXPECT_THAT(demands(actions), IsEmpty()) << "no limit is set";
  const auto shared = demands(room.change({.name = "lab", .uplink_mbit = 6}, at(1s)));
  ASSERT_EQ(shared.size(), 1U);
  EXPECT_EQ(shared[0].message.frame_demand().mbit(), 6);
  EXPECT_THAT(shared[0].to, testing::SizeIs(1));
  enter(sensor_that_follows("right"), 2s);
  ASSERT_EQ(demands(actions).size(), 1U) << "both have the same share";
  EXPECT_EQ(demands(actions)[0].message.frame_demand().mbit(), 3);
  EXPECT_THAT(demands(actions)[0].to, testing::SizeIs(2));
  EXPECT_EQ(room.stats().sensors[0].share_mbit, 3);
  const auto free = demands(room.change({.name = "lab"}, at(3s)));
  ASSERT_EQ(free.size(), 1U);
  EXPECT_EQ(free[0].message.frame_demand().mbit(), 0);
}

TEST_F(RoomTest, a_sensor_with_a_rate_of_its_own_gets_no_more) {
  enter(viewer_join());
  (void)room.change({.name = "lab", .uplink_mbit = 6}, at(1s));
  pb::Join join = sensor_that_follows("slow");
  join.mutable_sensor()->mutable_settings()->set_mbit(1);
  enter(join, 2s);
  enter(sensor_that_follows("fast"), 2s);
  EXPECT_EQ(room.stats().sensors[0].share_mbit, 1);
  EXPECT_EQ(room.stats().sensors[1].share_mbit, 5);
}

TEST_F(RoomTest, a_sensor_sends_its_small_rendition_while_some_viewer_needs_it) {
  const auto left = enter(sensor_join("left")), right = enter(sensor_join("right"));
  const auto slow = enter(viewer_join(), 1s), good = enter(viewer_join(), 1s);
  const auto begun =
      demands(room.small_needed(slow, {.wanted = {SensorId{1}}, .keys = {}}, at(2s)));
  ASSERT_EQ(begun.size(), 1U);
  EXPECT_THAT(begun[0].to, ElementsAre(right));
  EXPECT_TRUE(begun[0].message.frame_demand().small());
  EXPECT_TRUE(wanted(begun[0]));
  EXPECT_THAT(demands(room.small_needed(good, {.wanted = {}, .keys = {}}, at(3s))), IsEmpty());
  EXPECT_THAT(demands(room.small_needed(slow, {.wanted = {SensorId{1}, SensorId{0}}, .keys = {}},
                                        at(4s)))[0]
                  .to,
              ElementsAre(left));
  EXPECT_EQ(room.stats().viewers[0].small_sensors, 2u);
  EXPECT_EQ(room.stats().viewers[1].small_sensors, 0u);
  const auto ended = demands(room.leave(slow, at(5s)));
  ASSERT_EQ(ended.size(), 1U);
  EXPECT_THAT(ended[0].to, UnorderedElementsAre(left, right));
  EXPECT_FALSE(ended[0].message.frame_demand().small());
}

TEST_F(RoomTest, key_frames_of_the_small_rendition_are_asked_for_by_themselves) {
  const auto sensor = enter(sensor_join("left"));
  const auto viewer = enter(viewer_join(), 1s);
  const auto keys = [](const RoomActions& done) {
    return messages(done, pb::Control::kKeyRequest);
  };
  const SmallNeeds needs{.wanted = {SensorId{0}}, .keys = {SensorId{0}}};
  const auto asked = keys(room.small_needed(viewer, needs, at(2s)));
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_THAT(asked[0].to, ElementsAre(sensor));
  EXPECT_TRUE(asked[0].message.key_request().small());
  EXPECT_EQ(keys(room.key_needed(SensorId{0}, at(2s))).size(), 1U) << "it has a pace of its own";
  EXPECT_THAT(keys(room.small_needed(viewer, needs, at(2s + 1ms))), IsEmpty());
  EXPECT_EQ(keys(room.tick(at(2s + wire::kKeyRequestInterval + 1ms))).size(), 1U);
  EXPECT_THAT(room.small_needed(ConnectionId{99}, needs, at(9s)), IsEmpty()) << "it has left";
  EXPECT_THAT(keys(room.small_needed(viewer, {.wanted = {}, .keys = {SensorId{31}}}, at(9s))),
              IsEmpty())
      << "no such sensor";
}

}  // namespace
}  // namespace roomcast::hub
