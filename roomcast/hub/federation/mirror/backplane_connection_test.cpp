// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/mirror/backplane_connection.h"

#include <vector>

#include <gtest/gtest.h>

namespace roomcast::hub::federation {
namespace {

struct RecordedRoom final : BackplaneRoom {
  void on_room_message(ConnectionId to, const wire::pb::Control& message) override {
    EXPECT_TRUE(message.has_welcome());
    messages.push_back(to);
  }
  void on_removed(ConnectionId connection) override { removed.push_back(connection); }
  std::vector<ConnectionId> messages, removed;
};

wire::pb::Control welcome_control() {
  wire::pb::Control control;
  control.mutable_welcome();
  return control;
}

TEST(BackplaneConnection, delivers_messages_and_the_removal_to_its_room) {
  RecordedRoom room;
  BackplaneConnection connection(ConnectionId{7}, [&room] { return &room; });
  hub::Connection& client = connection;
  client.send(welcome_control());
  client.disconnect(wire::pb::ERROR_REPLACED, "");
  EXPECT_EQ(room.messages, std::vector{ConnectionId{7}});
  EXPECT_EQ(room.removed, std::vector{ConnectionId{7}});
}

TEST(BackplaneConnection, drops_messages_after_its_room_is_closed) {
  BackplaneConnection connection(ConnectionId{7}, [] { return nullptr; });
  hub::Connection& client = connection;
  client.send(welcome_control());
  client.disconnect(wire::pb::ERROR_REPLACED, "");
}

}  // namespace
}  // namespace roomcast::hub::federation
