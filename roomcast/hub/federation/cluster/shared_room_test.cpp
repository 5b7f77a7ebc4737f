// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/cluster/shared_room.h"

#include <vector>

#include <gtest/gtest.h>

#include "roomcast/hub/federation/mirror/room_here_fixture.h"

namespace roomcast::hub::federation {
namespace {

namespace wpb = wire::pb;
using hub::federation::person;
using hub::federation::pose_of;
using hub::federation::RoomHere;
using hub::federation::sensor_there;
using namespace std::chrono_literals;

constexpr HubId kOwn{5}, kLower{3}, kHigher{8};

struct Told final : SharedRoomOut {
  void broadcast_news(const pb::RoomNews& news) override { to_all.push_back(news); }
  void tell(HubId hub, const pb::ToHub& message) override { to_one.emplace_back(hub, message); }
  void broadcast_poses(const std::string&, const pb::PeopleMoved& people) override {
    moved.push_back(people);
  }
  std::vector<pb::RoomNews> to_all;
  std::vector<pb::PeopleMoved> moved;
  std::vector<std::pair<HubId, pb::ToHub>> to_one;
};

class SharedRoomTest : public testing::Test {
 protected:
  SharedRoomTest() {
    room.stay();
    welcome(0);
  }
  /// The room here sends a welcome to the `n`th client that joined, as sensor `id`.
  void welcome(std::size_t n, std::uint32_t id = 0) {
    wpb::Control control;
    control.mutable_welcome()->set_sensor_id(id);
    room.on_room_message(here.joins.at(n).first, control);
  }
  void roster(std::initializer_list<wpb::SensorEntry> sensors) {
    wpb::Control control;
    for (const auto& sensor : sensors) *control.mutable_roster()->add_sensors() = sensor;
    control.mutable_roster();
    room.on_room_message(here.joins.at(0).first, control);
  }
  static pb::RoomNews news_of(HubId hub, std::uint32_t revision,
                              std::initializer_list<wpb::SensorEntry> sensors,
                              std::uint32_t claim = 1) {
    pb::RoomNews news;
    news.set_hub(hub.value);
    news.set_room("lab");
    news.set_revision(revision);
    for (const auto& entry : sensors) {
      pb::SensorHere& sensor = *news.add_sensors();
      *sensor.mutable_entry() = entry;
      sensor.set_claim(claim);
      sensor.set_token_id("t");
    }
    return news;
  }
  pb::ToHub message_from(HubId hub) const {
    pb::ToHub message;
    message.set_from(hub.value);
    message.set_room("lab");
    return message;
  }

  RoomHere here;
  Told told;
  SharedRoom room{{.own = kOwn,
                   .room = "lab",
                   .token = "own",
                   .rooms = here,
                   .new_connection = unread_connections(),
                   .out = told}};
};

TEST_F(SharedRoomTest, others_are_told_what_sends_here_and_only_when_it_changes) {
  room.sensor_joins("left", "token-1");
  roster({sensor_there(2, "left")});
  roster({sensor_there(2, "left")});
  ASSERT_EQ(told.to_all.size(), 1u);
  EXPECT_EQ(told.to_all[0].revision(), 1u);
  EXPECT_EQ(told.to_all[0].sensors(0).entry().name(), "left");
  EXPECT_EQ(told.to_all[0].sensors(0).token_id(), "token-1");
  EXPECT_EQ(room.local_sensor_count(), 1u);
  roster({});
  ASSERT_EQ(told.to_all.size(), 2u);
  EXPECT_EQ(told.to_all[1].sensors_size(), 0);
}

TEST_F(SharedRoomTest, what_sends_to_another_hub_is_here_and_is_not_told_on) {
  room.news(news_of(kLower, 1, {sensor_there(7, "left")}));
  ASSERT_EQ(here.joins.size(), 2u);
  EXPECT_EQ(here.joins[1].second.name(), "left");
  EXPECT_EQ(here.arrivals[1].token_id_there, "t");
  welcome(1, 3);
  roster({sensor_there(3, "left")});
  EXPECT_TRUE(told.to_all.empty());
}

TEST_F(SharedRoomTest, old_news_and_illegal_ones_are_not_taken) {
  room.news(news_of(kLower, 2, {sensor_there(7, "left")}));
  room.news(news_of(kLower, 1, {}));
  EXPECT_TRUE(here.left.empty());
  auto nonsense = sensor_there(7, "bad\nname");
  room.news(news_of(kLower, 3, {nonsense}));
  EXPECT_EQ(room.revision_of(kLower), 2u);
  room.news(news_of(kLower, 4, {}));
  EXPECT_EQ(here.left.size(), 1u);
}

TEST_F(SharedRoomTest, who_comes_last_has_the_name_wherever_it_comes) {
  room.news(news_of(kLower, 1, {sensor_there(7, "left")}));
  welcome(1, 3);
  room.sensor_joins("left", "t");
  room.on_removed(here.joins[1].first);  // the room has replaced it
  roster({sensor_there(3, "left")});
  ASSERT_EQ(told.to_all.size(), 1u);
  EXPECT_EQ(told.to_all[0].sensors(0).claim(), 2u);
  room.news(news_of(kLower, 2, {sensor_there(7, "left"), sensor_there(9, "other")}));
  EXPECT_EQ(here.joins.size(), 3u) << "ours came later; the other sensor is new";
  room.news(news_of(kHigher, 1, {sensor_there(4, "left")}, 3));
  EXPECT_EQ(here.joins.size(), 4u) << "it came later still, and replaces ours here";
}

TEST_F(SharedRoomTest, of_two_that_came_at_the_same_time_all_hubs_choose_the_same) {
  room.sensor_joins("left", "t");
  roster({sensor_there(3, "left")});
  room.news(news_of(kLower, 1, {sensor_there(7, "left")}));
  EXPECT_EQ(here.joins.size(), 1u) << "our id is higher";
  room.news(news_of(kHigher, 1, {sensor_there(7, "left")}));
  EXPECT_EQ(here.joins.size(), 2u) << "its id is higher";
}

TEST_F(SharedRoomTest, when_a_hub_is_gone_its_sensors_are_and_the_next_ones_take_their_names) {
  room.news(news_of(kLower, 1, {sensor_there(7, "left")}, 1));
  room.news(news_of(kHigher, 1, {sensor_there(4, "left")}, 2));
  EXPECT_EQ(here.left.size(), 1u);
  EXPECT_EQ(here.joins.size(), 3u);
  room.remove_hub(kHigher);
  EXPECT_EQ(here.left.size(), 2u);
  EXPECT_EQ(here.joins.size(), 4u);
  EXPECT_EQ(room.revision_of(kHigher), 0u) << "it may come back";
}

TEST_F(SharedRoomTest, frames_come_in_with_this_hubs_time) {
  room.news(news_of(kLower, 1, {sensor_there(7, "left")}));
  welcome(1, 3);
  room.set_clock(kLower, {.at = HostTime(14s), .room_minus_host = -4s, .drift = 0, .error = 50us});
  FramePacker packer(10'000);
  auto frame = hub::federation::frame_there();
  packer.add(frame.payload());
  for (const auto& message : packer.take()) {
    room.frames(kLower, message);
    room.frames(kHigher, message);  // kHigher has no sensors
  }
  ASSERT_EQ(here.frames.size(), 1u);
  EXPECT_EQ(here.frames[0].second.capture_time, RoomTime(14s));
}

TEST_F(SharedRoomTest, a_key_request_goes_to_the_hub_of_the_sensor_and_from_there_to_it) {
  room.news(news_of(kLower, 1, {sensor_there(7, "left")}));
  welcome(1, 3);
  wpb::Control request;
  request.mutable_key_request()->set_sensor_id(3);
  room.on_room_message(here.joins[1].first, request);
  ASSERT_EQ(told.to_one.size(), 1u);
  EXPECT_EQ(told.to_one[0].first, kLower);
  EXPECT_EQ(told.to_one[0].second.key_request().sensor_id(), 7u);
  auto message = message_from(kLower);
  message.mutable_key_request()->set_sensor_id(2);
  room.take(message);
  EXPECT_EQ(here.key_needs, std::vector{SensorId{2}});
}

TEST_F(SharedRoomTest, who_missed_news_is_told_again) {
  room.sensor_joins("left", "t");
  roster({sensor_there(3, "left")});
  auto please = message_from(kLower);
  please.mutable_news_please();
  room.take(please);
  ASSERT_EQ(told.to_all.size(), 2u);
  EXPECT_EQ(told.to_all[1].revision(), told.to_all[0].revision());
}

TEST_F(SharedRoomTest, the_room_here_is_told_where_else_it_is_when_that_changes) {
  room.set_other_urls({});
  EXPECT_TRUE(here.said.empty());
  room.set_other_urls({"wss://a"});
  room.set_other_urls({"wss://a"});
  ASSERT_EQ(here.said.size(), 1u);
  EXPECT_EQ(here.said[0].second.other_hubs().urls(0), "wss://a");
}

TEST_F(SharedRoomTest, it_joins_again_when_it_was_sent_away) {
  room.on_removed(here.joins[0].first);
  room.stay();
  room.stay();
  EXPECT_EQ(here.joins.size(), 2u);
}

TEST_F(SharedRoomTest, who_watches_here_is_told_and_who_came_from_other_hubs_is_not) {
  wpb::Control control;
  *control.mutable_roster()->add_viewers() = person(7, "Ada");
  *control.mutable_roster()->add_viewers() = person(9, "from there", 1);
  room.on_room_message(here.joins.at(0).first, control);
  ASSERT_EQ(told.to_all.back().people_size(), 1);
  EXPECT_EQ(told.to_all.back().people(0).name(), "Ada");
  EXPECT_EQ(room.viewer_count(), 1u);
  room.on_room_message(here.joins.at(0).first, pose_of(7));
  room.on_room_message(here.joins.at(0).first, pose_of(9));
  ASSERT_EQ(told.moved.size(), 1u);
  EXPECT_EQ(told.moved[0].poses().poses(0).viewer_id(), 7u);
  room.tell_poses_again();
  EXPECT_EQ(told.moved.size(), 2u);
}

TEST_F(SharedRoomTest, who_watches_at_other_hubs_is_shown_here_and_goes_with_the_hub) {
  auto news = news_of(kLower, 1, {});
  *news.add_people() = person(7, "Ada");
  room.news(news);
  news = news_of(kHigher, 1, {});
  *news.add_people() = person(7, "Bob");
  room.news(news);
  ASSERT_EQ(here.said.size(), 2u);
  const auto& both = here.said[1].second.people_here();
  ASSERT_EQ(both.people_size(), 2);
  EXPECT_NE(both.people(0).id(), both.people(1).id()) << "both hubs call theirs 7";
  pb::PeopleMoved moved;
  moved.set_hub(kHigher.value);
  *moved.mutable_poses() = pose_of(7).viewer_poses();
  room.people_moved(moved);
  EXPECT_EQ(here.said.back().second.viewer_poses().poses(0).viewer_id(), both.people(1).id());
  room.remove_hub(kLower);
  ASSERT_EQ(here.said.back().second.people_here().people_size(), 1);
  EXPECT_EQ(here.said.back().second.people_here().people(0).id(), both.people(1).id());
}

TEST_F(SharedRoomTest, nobody_moves_people_of_another_hub_or_with_poses_that_make_no_sense) {
  auto news = news_of(kLower, 1, {});
  *news.add_people() = person(7, "Ada");
  room.news(news);
  const auto said = here.said.size();
  pb::PeopleMoved moved;
  moved.set_hub(kHigher.value);
  *moved.mutable_poses() = pose_of(7).viewer_poses();
  room.people_moved(moved);
  EXPECT_EQ(here.said.back().second.viewer_poses().poses_size(), 0);
  moved.set_hub(kLower.value);
  moved.mutable_poses()->mutable_poses(0)->mutable_head()->set_qw(7);
  room.people_moved(moved);
  EXPECT_LE(here.said.size(), said + 1);
}

}  // namespace
}  // namespace roomcast::hub::federation
