// SPDX-License-Identifier: Apache-2.0
// tests/cli/foxglove.test.mjs bridges a room with sensors.
#include "roomcast/foxglove/room_bridge.h"

#include <chrono>

#include <gtest/gtest.h>

#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"

namespace roomcast::foxglove {
namespace {

class RoomBridgeTest : public testing::Test {
 protected:
  RoomBridgeTest() { network.start(); }
  ~RoomBridgeTest() override {
    room.reset();
    network.finish([this] { hub.reset(); });
  }

  void open() {
    auto opened =
        client::Subscriber::open({.hub_url = hub->url(), .room = {}, .name = "bridge", .log = {}});
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    room = std::move(*opened);
    server = std::move(*FoxgloveServer::listen({.port = 0}));
  }

  client::NetworkThread network;
  std::unique_ptr<client::FakeHub> hub = std::make_unique<client::FakeHub>(network.io());
  std::unique_ptr<client::Subscriber> room;
  std::unique_ptr<FoxgloveServer> server;
};

TEST_F(RoomBridgeTest, ends_when_it_is_stopped) {
  open();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(bridge_room(*room, *server, {}, stop.get_token()).ok());
}

TEST_F(RoomBridgeTest, a_room_that_may_not_be_exported_is_refused) {
  network.run([&] { hub->lets_export = false; });
  open();
  const Status status = bridge_room(*room, *server, {}, {});
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::foxglove
