// SPDX-License-Identifier: Apache-2.0
// tests/cli/ros2.test.mjs bridges a room with sensors.
#include "roomcast/ros2/bridge/room_bridge.h"

#include <gtest/gtest.h>

#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/ros2/dds/dds_fixture.h"

namespace roomcast::ros2 {
namespace {

class Ros2RoomBridge : public testing::Test {
 protected:
  Ros2RoomBridge() { network.start(); }
  ~Ros2RoomBridge() override {
    room.reset();
    network.finish([this] { hub.reset(); });
  }

  void open() {
    auto opened =
        client::Subscriber::open({.hub_url = hub->url(), .room = {}, .name = "bridge", .log = {}});
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    room = std::move(*opened);
  }

  client::NetworkThread network;
  std::unique_ptr<client::FakeHub> hub = std::make_unique<client::FakeHub>(network.io());
  std::unique_ptr<client::Subscriber> room;
  std::unique_ptr<Participant> participant = join_test_domain();
  std::unique_ptr<RoomTopics> topics = *RoomTopics::open(*participant, {});
};

TEST_F(Ros2RoomBridge, tells_the_topics_and_ends_when_it_is_stopped) {
  open();
  std::stop_source stop;
  std::vector<std::string> told;
  const auto on_topics = [&](const std::vector<std::string>& names) {
    told = names;
    stop.request_stop();
  };
  EXPECT_TRUE(bridge_room(*room, *topics, {.on_topics = on_topics}, stop.get_token()).ok());
  EXPECT_EQ(told, (std::vector<std::string>{"/roomcast/points", "/tf_static"}));
}

TEST_F(Ros2RoomBridge, a_room_that_may_not_be_exported_is_refused) {
  network.run([&] { hub->lets_export = false; });
  open();
  const Status status = bridge_room(*room, *topics, {}, {});
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::ros2
