// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/subscriber.h"

#include <thread>

#include <gtest/gtest.h>

#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/client/room/calibration_message.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

constexpr int kWidth = 64, kHeight = 48;
constexpr SetId kSet{3};  // of all frames

wire::pb::Control roster_of_one() {
  SensorCalibration calibration;
  calibration.depth = {.width = kWidth, .height = kHeight, .fx = 60, .fy = 60, .cx = 32, .cy = 24};
  calibration.color = calibration.depth;
  wire::pb::Control control;
  auto& sensor = *control.mutable_roster()->add_sensors();
  sensor.set_id(0);
  sensor.set_name("left");
  sensor.set_online(true);
  sensor.set_fps(30);
  *sensor.mutable_calibration() = message_from_calibration(calibration);
  wire::write_transform({}, *sensor.mutable_world_from_depth());
  return control;
}

net::FramedMessagePtr frame_message(bool key, SensorId sensor = {}, bool last = true) {
  codec::FrameEncoderOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.depth_mode = codec::DepthMode::kLossless;
  net::MessageBuffer message;
  message.appendable().resize(net::MessageBuffer::kHeadroom + wire::kFrameHeaderBytes);
  const DepthImage depth(kWidth, kHeight, 1234);
  EXPECT_TRUE((*codec::FrameEncoder::create(options))
                  ->encode(depth, {}, {}, true, message.appendable())
                  .ok());
  wire::FrameHeader header;
  header.key = key;
  header.sensor = sensor;
  header.last = last;
  header.set = kSet;
  header.seq = 7;
  header.base_seq = key ? 7 : 6;
  header.payload_length = static_cast<std::uint32_t>(message.size() - wire::kFrameHeaderBytes);
  wire::write_frame_header(header, message.payload().first<wire::kFrameHeaderBytes>());
  return net::frame_message(std::move(message));
}

class SubscriberTest : public testing::Test {
 protected:
  SubscriberTest() { network.start(); }
  ~SubscriberTest() override {
    subscriber.reset();
    network.finish([this] { hub.reset(); });
  }

  void open() {
    auto opened = Subscriber::open({.hub_url = hub->url(), .room = {}, .name = "Ada", .log = {}});
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    subscriber = std::move(*opened);
  }

  template <class Action>
  void on_hub(Action action) {
    network.run([&] { action(*hub); });
  }

  template <class Wanted>
  std::shared_ptr<const RoomSnapshot> wait_for(Wanted wanted) {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    auto room = subscriber->snapshot();
    while (!wanted(*room) && std::chrono::steady_clock::now() < give_up) {
      room = subscriber->wait_newer(room->revision, 50ms);
    }
    EXPECT_TRUE(wanted(*room));
    return room;
  }

  NetworkThread network;
  std::optional<FakeHub> hub{std::in_place, network.io()};
  std::unique_ptr<Subscriber> subscriber;
};

TEST_F(SubscriberTest, shows_the_frames_of_the_hub) {
  open();
  on_hub([](FakeHub& h) {
    h.say(roster_of_one());
    h.say(frame_message(true));
  });
  const auto room =
      wait_for([](const auto& r) { return !r.sensors.empty() && r.sensors[0].picture; });
  EXPECT_EQ(room->room, "lab");
  EXPECT_EQ(room->sensors[0].name, "left");
  EXPECT_EQ(room->sensors[0].picture->seq, 7u);
  EXPECT_EQ(room->sensors[0].picture->frame.depth_mm, DepthImage(kWidth, kHeight, 1234));
}

TEST_F(SubscriberTest, a_set_without_its_last_frame_is_shown_at_its_end) {
  open();
  wire::pb::Control end;
  end.mutable_set_end()->set_set_id(kSet.value);
  on_hub([&](FakeHub& h) {
    h.say(roster_of_one());
    h.say(frame_message(true, {}, false));
  });
  std::this_thread::sleep_for(100ms);
  ASSERT_FALSE(subscriber->snapshot()->sensors.empty());
  EXPECT_EQ(subscriber->snapshot()->sensors[0].picture, nullptr) << "the set may have more frames";
  on_hub([&](FakeHub& h) { h.say(end); });
  wait_for([](const auto& r) { return r.sensors[0].picture != nullptr; });
}

TEST_F(SubscriberTest, a_paused_sensor_is_known_as_such_until_its_next_frame) {
  open();
  wire::pb::Control unseen;
  unseen.mutable_unseen_sensors()->add_paused(0);
  on_hub([&](FakeHub& h) {
    h.say(roster_of_one());
    h.say(unseen);
  });
  wait_for([](const auto& r) { return !r.sensors.empty() && r.sensors[0].is_paused; });
  on_hub([&](FakeHub& h) { h.say(frame_message(true)); });
  wait_for([](const auto& r) { return !r.sensors[0].is_paused; });
}

TEST_F(SubscriberTest, a_sensor_that_cannot_be_decoded_does_not_hide_the_others_of_its_set) {
  open();
  wire::pb::Control roster = roster_of_one();
  *roster.mutable_roster()->add_sensors() = roster.roster().sensors(0);
  roster.mutable_roster()->mutable_sensors(1)->set_id(1);
  roster.mutable_roster()->mutable_sensors(1)->set_name("broken");
  on_hub([&](FakeHub& h) {
    h.say(roster);
    h.say(frame_message(true, SensorId{0}, false));
    h.say(frame_message(false, SensorId{1}, true));
  });
  const auto room =
      wait_for([](const auto& r) { return r.sensors.size() == 2 && r.sensors[0].picture; });
  EXPECT_FALSE(room->sensors[1].picture);
}

TEST_F(SubscriberTest, sends_its_pose_and_receives_those_of_others) {
  open();
  PersonPose own;
  own.world_from_head.translation_m = {1, 1.5, 2};
  subscriber->send_pose(own);
  subscriber->send_stats({SetId{12}, 29.5, 80});
  const auto give_up = std::chrono::steady_clock::now() + 5s;
  bool heard = false;
  while (!heard && std::chrono::steady_clock::now() < give_up) {
    on_hub([&](FakeHub& h) { heard = h.heard.back().has_viewer_stats(); });
  }
  on_hub([](FakeHub& h) {
    ASSERT_EQ(h.heard.size(), 3U);  // a join before them
    EXPECT_EQ(h.heard[1].viewer_pose().head().y(), 1.5F);
    EXPECT_EQ(h.heard[2].viewer_stats().last_set_id(), 12U);
    wire::pb::Control roster;
    roster.mutable_roster()->add_viewers()->set_id(3);
    h.say(roster);
    wire::pb::Control poses;
    auto& pose = *poses.mutable_viewer_poses()->add_poses();
    pose.set_viewer_id(3);
    pose.mutable_head()->set_qw(1);
    pose.mutable_head()->set_z(4);
    h.say(poses);
  });
  const auto room =
      wait_for([](const auto& r) { return !r.people.empty() && r.people[0].pose.has_value(); });
  EXPECT_EQ(room->people[0].pose->world_from_head.translation_m.z(), 4);
}

TEST_F(SubscriberTest, asks_for_a_key_frame_when_it_cannot_decode) {
  open();
  on_hub([](FakeHub& h) {
    h.say(roster_of_one());
    h.say(frame_message(false));
  });
  const auto give_up = std::chrono::steady_clock::now() + 5s;
  bool asked = false;
  while (!asked && std::chrono::steady_clock::now() < give_up) {
    on_hub([&](FakeHub& h) { asked = h.heard.back().has_key_request(); });
  }
  EXPECT_TRUE(asked);
}

TEST_F(SubscriberTest, says_why_it_is_alone_and_comes_back) {
  open();
  on_hub([](FakeHub& h) { h.hang_up(); });
  const auto alone = wait_for([](const auto& r) { return !r.connected; });
  EXPECT_NE(alone->problem.find("the hub stops"), std::string::npos);
  EXPECT_FALSE(subscriber->failure().has_value());
  wait_for([](const auto& r) { return r.connected; });
}

TEST_F(SubscriberTest, a_refusal_is_final) {
  open();
  on_hub([](FakeHub& h) { h.refuse(wire::pb::ERROR_REPLACED, "somebody else"); });
  wait_for([](const auto& r) { return !r.connected; });
  ASSERT_TRUE(subscriber->failure().has_value());
  EXPECT_EQ(subscriber->failure()->message, "the hub says: somebody else");
}

TEST_F(SubscriberTest, invalid_addresses_are_refused_at_once) {
  const auto opened = Subscriber::open({.hub_url = "ftp://x", .room = {}, .name = {}, .log = {}});
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(opened.error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace roomcast::client
