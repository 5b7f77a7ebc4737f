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

struct SentMessages final : SharedRoomOut {
  void broadcast_news(const pb::RoomNews& news) override { to_all.push_back(news); }
  void send_to(HubId hub, const pb::ToHub& message) override { to_one.emplace_back(hub, message); }
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
    room.ensure_joined();
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
  SentMessages sent;
  SharedRoom room{{.own = kOwn,
                   .room = "lab",
                   .token = "own",
                   .rooms = here,
                   .new_connection = unread_connections(),
                   .out = sent}};
};

TEST_F(SharedRoomTest, publishes_the_sensors_here_on_changes_only) {
  room.sensor_joins("left", "token-1");
  roster({sensor_there(2, "left")});
  roster({sensor_there(2, "left")});
  ASSERT_EQ(sent.to_all.size(), 1u);
  EXPECT_EQ(sent.to_all[0].revision(), 1u);
  EXPECT_EQ(sent.to_all[0].sensors(0).entry().name(), "left");
  EXPECT_EQ(sent.to_all[0].sensors(0).token_id(), "token-1");
  EXPECT_EQ(room.local_sensor_count(), 1u);
  roster({});
  ASSERT_EQ(sent.to_all.size(), 2u);
  EXPECT_EQ(sent.to_all[1].sensors_size(), 0);
}

TEST_F(SharedRoomTest, mirrors_sensors_of_other_hubs_without_publishing_them) {
  room.on_news(news_of(kLower, 1, {sensor_there(7, "left")}));
  ASSERT_EQ(here.joins.size(), 2u);
  EXPECT_EQ(here.joins[1].second.name(), "left");
  EXPECT_EQ(here.arrivals[1].token_id_there, "t");
  welcome(1, 3);
  roster({sensor_there(3, "left")});
  EXPECT_TRUE(sent.to_all.empty());
}

TEST_F(SharedRoomTest, rejects_old_and_invalid_news) {
  room.on_news(news_of(kLower, 2, {sensor_there(7, "left")}));
  room.on_news(news_of(kLower, 1, {}));
  EXPECT_TRUE(here.left.empty());
  auto nonsense = sensor_there(7, "bad\nname");
  room.on_news(news_of(kLower, 3, {nonsense}));
  EXPECT_EQ(room.revision_of(kLower), 2u);
  room.on_news(news_of(kLower, 4, {}));
  EXPECT_EQ(here.left.size(), 1u);
}

TEST_F(SharedRoomTest, the_last_sensor_to_join_gets_the_name) {
  room.on_news(news_of(kLower, 1, {sensor_there(7, "left")}));
  welcome(1, 3);
  room.sensor_joins("left", "t");
  room.on_removed(here.joins[1].first);  // the room has replaced it
  roster({sensor_there(3, "left")});
  ASSERT_EQ(sent.to_all.size(), 1u);
  EXPECT_EQ(sent.to_all[0].sensors(0).claim(), 2u);
  room.on_news(news_of(kLower, 2, {sensor_there(7, "left"), sensor_there(9, "other")}));
  EXPECT_EQ(here.joins.size(), 3u) << "ours came later; the other sensor is new";
  room.on_news(news_of(kHigher, 1, {sensor_there(4, "left")}, 3));
  EXPECT_EQ(here.joins.size(), 4u) << "it came later still, and replaces ours here";
}

TEST_F(SharedRoomTest, all_hubs_choose_the_same_of_two_simultaneous_claims) {
  room.sensor_joins("left", "t");
  roster({sensor_there(3, "left")});
  room.on_news(news_of(kLower, 1, {sensor_there(7, "left")}));
  EXPECT_EQ(here.joins.size(), 1u) << "our id is higher";
  room.on_news(news_of(kHigher, 1, {sensor_there(7, "left")}));
  EXPECT_EQ(here.joins.size(), 2u) << "its id is higher";
}

TEST_F(SharedRoomTest, sensors_of_a_lost_hub_leave_and_free_their_names) {
  room.on_news(news_of(kLower, 1, {sensor_there(7, "left")}, 1));
  room.on_news(news_of(kHigher, 1, {sensor_there(4, "left")}, 2));
  EXPECT_EQ(here.left.size(), 1u);
  EXPECT_EQ(here.joins.size(), 3u);
  room.remove_hub(kHigher);
  EXPECT_EQ(here.left.size(), 2u);
  EXPECT_EQ(here.joins.size(), 4u);
  EXPECT_EQ(room.revision_of(kHigher), 0u) << "it may come back";
}

TEST_F(SharedRoomTest, frames_get_this_hubs_time) {
  room.on_news(news_of(kLower, 1, {sensor_there(7, "left")}));
  welcome(1, 3);
  room.set_clock(kLower, {.at = HostTime(14s), .room_minus_host = -4s, .drift = 0, .error = 50us});
  FramePacker packer(10'000);
  auto frame = hub::federation::frame_there();
  packer.add(frame.payload());
  for (const auto& message : packer.take()) {
    room.on_frames(kLower, message);
    room.on_frames(kHigher, message);  // kHigher has no sensors
  }
  ASSERT_EQ(here.frames.size(), 1u);
  EXPECT_EQ(here.frames[0].second.capture_time, RoomTime(14s));
}

TEST_F(SharedRoomTest, a_key_request_reaches_a_sensor_of_another_hub) {
  room.on_news(news_of(kLower, 1, {sensor_there(7, "left")}));
  welcome(1, 3);
  wpb::Control request;
  request.mutable_key_request()->set_sensor_id(3);
  room.on_room_message(here.joins[1].first, request);
  ASSERT_EQ(sent.to_one.size(), 1u);
  EXPECT_EQ(sent.to_one[0].first, kLower);
  EXPECT_EQ(sent.to_one[0].second.key_request().sensor_id(), 7u);
  auto message = message_from(kLower);
  message.mutable_key_request()->set_sensor_id(2);
  room.on_message(message);
  EXPECT_EQ(here.key_needs, std::vector{SensorId{2}});
}

TEST_F(SharedRoomTest, news_are_repeated_on_request) {
  room.sensor_joins("left", "t");
  roster({sensor_there(3, "left")});
  auto please = message_from(kLower);
  please.mutable_news_please();
  room.on_message(please);
  ASSERT_EQ(sent.to_all.size(), 2u);
  EXPECT_EQ(sent.to_all[1].revision(), sent.to_all[0].revision());
}

TEST_F(SharedRoomTest, reports_changed_urls_of_other_hubs_to_the_room) {
  room.set_other_urls({});
  EXPECT_TRUE(here.controls.empty());
  room.set_other_urls({"wss://a"});
  room.set_other_urls({"wss://a"});
  ASSERT_EQ(here.controls.size(), 1u);
  EXPECT_EQ(here.controls[0].second.other_hubs().urls(0), "wss://a");
}

TEST_F(SharedRoomTest, rejoins_after_a_disconnect) {
  room.on_removed(here.joins[0].first);
  room.ensure_joined();
  room.ensure_joined();
  EXPECT_EQ(here.joins.size(), 2u);
}

TEST_F(SharedRoomTest, reports_people_of_this_hub_only) {
  wpb::Control control;
  *control.mutable_roster()->add_viewers() = person(7, "Ada");
  *control.mutable_roster()->add_viewers() = person(9, "from there", 1);
  room.on_room_message(here.joins.at(0).first, control);
  ASSERT_EQ(sent.to_all.back().people_size(), 1);
  EXPECT_EQ(sent.to_all.back().people(0).name(), "Ada");
  EXPECT_EQ(room.viewer_count(), 1u);
  room.on_room_message(here.joins.at(0).first, pose_of(7));
  room.on_room_message(here.joins.at(0).first, pose_of(9));
  ASSERT_EQ(sent.moved.size(), 1u);
  EXPECT_EQ(sent.moved[0].poses().poses(0).viewer_id(), 7u);
  room.resend_poses();
  EXPECT_EQ(sent.moved.size(), 2u);
}

TEST_F(SharedRoomTest, shows_people_of_other_hubs_until_the_hub_is_gone) {
  auto news = news_of(kLower, 1, {});
  *news.add_people() = person(7, "Ada");
  room.on_news(news);
  news = news_of(kHigher, 1, {});
  *news.add_people() = person(7, "Bob");
  room.on_news(news);
  ASSERT_EQ(here.controls.size(), 2u);
  const auto& both = here.controls[1].second.people_here();
  ASSERT_EQ(both.people_size(), 2);
  EXPECT_NE(both.people(0).id(), both.people(1).id()) << "both hubs call theirs 7";
  pb::PeopleMoved moved;
  moved.set_hub(kHigher.value);
  *moved.mutable_poses() = pose_of(7).viewer_poses();
  room.on_poses(moved);
  EXPECT_EQ(here.controls.back().second.viewer_poses().poses(0).viewer_id(), both.people(1).id());
  room.remove_hub(kLower);
  ASSERT_EQ(here.controls.back().second.people_here().people_size(), 1);
  EXPECT_EQ(here.controls.back().second.people_here().people(0).id(), both.people(1).id());
}

TEST_F(SharedRoomTest, rejects_poses_of_foreign_people_and_invalid_poses) {
  auto news = news_of(kLower, 1, {});
  *news.add_people() = person(7, "Ada");
  room.on_news(news);
  const auto before = here.controls.size();
  pb::PeopleMoved moved;
  moved.set_hub(kHigher.value);
  *moved.mutable_poses() = pose_of(7).viewer_poses();
  room.on_poses(moved);
  EXPECT_EQ(here.controls.back().second.viewer_poses().poses_size(), 0);
  moved.set_hub(kLower.value);
  moved.mutable_poses()->mutable_poses(0)->mutable_head()->set_qw(7);
  room.on_poses(moved);
  EXPECT_LE(here.controls.size(), before + 1);
}

}  // namespace
}  // namespace roomcast::hub::federation
