// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/room_runner.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

/// A client without a socket: it records what the room sends to it.
class RecordedConnection final : public Connection {
 public:
  using Connection::Connection;
  void accept(Role role, RoomId) override { roles.push_back(role); }
  void deliver(ControlFanOut& control) override { received.push_back(control.message()); }
  void disconnect(pb::ErrorCode code, const std::string&) override { ends.push_back(code); }

  [[nodiscard]] bool has_received(pb::Control::MessageCase kind) const {
    return std::ranges::any_of(
        received, [kind](const pb::Control& message) { return message.message_case() == kind; });
  }

  std::vector<Role> roles;
  std::vector<pb::Control> received;
  std::vector<pb::ErrorCode> ends;
};

class RecordedBackplane final : public Backplane {
 public:
  void sensor_joins(const std::string&, const std::string& name, const std::string&) override {
    sensors.push_back(name);
  }
  void frame(const std::string&, const wire::FrameHeader& header,
             std::span<const std::uint8_t>) override {
    frames.push_back(header.seq);
  }
  void watch(const std::string&, bool is_watched) override { watched.push_back(is_watched); }

  std::vector<std::string> sensors;
  std::vector<std::uint32_t> frames;
  std::vector<bool> watched;
};

pb::Join runner_sensor_join(const std::string& name) {
  pb::Join join;
  join.set_name(name);
  join.mutable_sensor()->set_fps(30);
  return join;
}

pb::Join runner_viewer_join() {
  pb::Join join;
  join.mutable_viewer();
  return join;
}

class RoomRunnerTest : public testing::Test {
 protected:
  std::shared_ptr<RecordedConnection> enter(const pb::Join& join, const Entry& entry = {}) {
    auto client = std::make_shared<RecordedConnection>(ids.next());
    runner->join(client, join, entry);
    return client;
  }
  static IncomingFrame frame_of(const Connection& sensor, std::uint32_t seq) {
    const wire::FrameHeader header{.key = true, .seq = seq, .base_seq = seq};
    std::vector<std::uint8_t> bytes(wire::kFrameHeaderBytes);
    wire::write_frame_header(header, std::span(bytes).first<wire::kFrameHeaderBytes>());
    return {sensor.id(), header, net::MessageBuffer(bytes)};
  }

  boost::asio::io_context io;
  StoreWorker store_worker{std::move(*HubStore::open(std::nullopt)), io};
  RecordedBackplane backplane;
  SteadyClock clock;
  ConnectionIds ids;
  std::vector<ConnectionId> removed;
  std::shared_ptr<RoomRunner> runner = std::make_shared<RoomRunner>(
      RoomId{1}, Room({.name = "lab"}, "test"),
      RoomRunner::Context{
          .io = io,
          .shards = {},
          .store_worker = store_worker,
          .backplane = &backplane,
          .clock = clock,
          .warn = [](const std::string&) {},
          .on_removed = [this](const Disconnect& end) { removed.push_back(end.connection); }});
};

TEST_F(RoomRunnerTest, a_client_that_joins_is_accepted_and_gets_a_welcome_and_the_roster) {
  const auto viewer = enter(runner_viewer_join());
  EXPECT_EQ(viewer->roles, std::vector{Role::kViewer});
  EXPECT_TRUE(viewer->has_received(pb::Control::kWelcome));
  EXPECT_TRUE(viewer->has_received(pb::Control::kRoster));
}

TEST_F(RoomRunnerTest,
       the_backplane_is_notified_of_local_sensors_and_of_the_first_and_last_viewer) {
  enter(runner_sensor_join("here"));
  enter(runner_sensor_join("there"), {.is_backplane = true});
  EXPECT_EQ(backplane.sensors, std::vector<std::string>{"here"});
  const auto first = enter(runner_viewer_join()), second = enter(runner_viewer_join());
  runner->leave(first->id());
  runner->leave(second->id());
  EXPECT_EQ(backplane.watched, (std::vector{true, false}));
}

TEST_F(RoomRunnerTest, the_backplane_gets_accepted_frames_of_local_sensors_only) {
  const auto sensor = enter(runner_sensor_join("here"));
  const auto viewer = enter(runner_viewer_join());
  auto [from, header, message] = frame_of(*sensor, 1);
  runner->frame(from, header, std::move(message));
  auto incoming = frame_of(*sensor, 2);
  runner->frames({&incoming, 1});
  auto refused = frame_of(*viewer, 3);
  runner->frame(refused.from, refused.header, std::move(refused.message));
  EXPECT_EQ(backplane.frames, std::vector{1u});
  EXPECT_EQ(runner->stats().sensors.at(0).frames, 2u);
  EXPECT_EQ(viewer->ends, std::vector{pb::ERROR_UNEXPECTED});
}

TEST_F(RoomRunnerTest, a_disconnected_client_gets_the_reason_once_and_no_message_after_it) {
  const auto viewer = enter(runner_viewer_join());
  runner->disconnect_client(viewer->id(), pb::ERROR_TOKEN_EXPIRED, "expired");
  runner->disconnect_client(viewer->id(), pb::ERROR_TOKEN_EXPIRED, "expired");
  viewer->received.clear();
  runner->send(viewer->id(), {});
  enter(runner_sensor_join("here"));
  EXPECT_EQ(viewer->ends, std::vector{pb::ERROR_TOKEN_EXPIRED});
  EXPECT_EQ(removed, std::vector{viewer->id()});
  EXPECT_TRUE(viewer->received.empty());
}

TEST_F(RoomRunnerTest, a_key_request_reaches_the_sensor) {
  const auto sensor = enter(runner_sensor_join("here"));
  runner->request_keys({SensorId{0}, SensorId{7}});
  EXPECT_TRUE(sensor->has_received(pb::Control::kKeyRequest));
}

TEST_F(RoomRunnerTest, closing_disconnects_every_client) {
  const auto sensor = enter(runner_sensor_join("here"));
  const auto viewer = enter(runner_viewer_join());
  runner->close("this room was closed");
  EXPECT_EQ(sensor->ends, std::vector{pb::ERROR_NOT_ALLOWED});
  EXPECT_EQ(viewer->ends, std::vector{pb::ERROR_NOT_ALLOWED});
  EXPECT_EQ(removed.size(), 2u);
}

}  // namespace
}  // namespace roomcast::hub
