// SPDX-License-Identifier: Apache-2.0
// For tests: a running hub on loopback, and clients that exchange single messages with it.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <gtest/gtest.h>

#include "roomcast/core/clock.h"
#include "roomcast/hub/room/framed_control.h"
#include "roomcast/hub/server/hub_server.h"
#include "roomcast/net/websocket_client.h"
#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

using namespace std::chrono_literals;
namespace pb = wire::pb;

/// Sends the given messages and stores the hub's answers.
class RawClient final : public net::ConnectionHandler {
 public:
  explicit RawClient(std::deque<net::FramedMessagePtr> to_send) : to_send_(std::move(to_send)) {}
  void on_message(net::MessageBuffer message) override {
    if (*wire::message_type(message.payload()) == wire::MessageType::kFrame) {
      frames.push_back(*wire::parse_frame(message.payload()));
      return;
    }
    if (*wire::message_type(message.payload()) == wire::MessageType::kAudio) {
      audio.push_back(*wire::parse_audio(message.payload()));
      return;
    }
    auto control = wire::decode_control(message.payload(), wire::Sender::kHub);
    ASSERT_TRUE(control.ok());
    received.push_back(std::move(*control));
  }
  net::FramedMessagePtr next_message() override {
    if (to_send_.empty()) return nullptr;
    auto message = to_send_.front();
    to_send_.pop_front();
    return message;
  }
  void on_closed(const net::CloseReason& reason) override { closed = reason; }

  void send(net::FramedMessagePtr message) { to_send_.push_back(std::move(message)); }

  std::vector<pb::Control> received;
  std::vector<wire::FrameHeader> frames;
  std::vector<wire::AudioHeader> audio;
  std::optional<net::CloseReason> closed;

 private:
  std::deque<net::FramedMessagePtr> to_send_;
};

inline net::FramedMessagePtr clock_ping(std::uint64_t client_ns) {
  pb::Control control;
  control.mutable_clock_ping()->set_client_ns(client_ns);
  return framed_control(control);
}

inline void set_camera(pb::Intrinsics& camera) {
  camera.set_width(512);
  camera.set_height(424);
  camera.set_fx(360);
  camera.set_fy(360);
  camera.set_cx(256);
  camera.set_cy(212);
}

inline pb::Control join_as_sensor(const std::string& name) {
  pb::Control control;
  control.mutable_join()->set_name(name);
  auto& sensor = *control.mutable_join()->mutable_sensor();
  sensor.set_fps(wire::kMaxFps);
  auto& calibration = *sensor.mutable_calibration();
  set_camera(*calibration.mutable_depth());
  set_camera(*calibration.mutable_color());
  for (int i = 0; i < 16; ++i) calibration.add_color_from_depth(i % 5 == 0 ? 1 : 0);
  return control;
}

inline net::FramedMessagePtr key_frame(std::uint32_t seq) {
  const wire::FrameHeader header{.key = true,
                                 .seq = seq,
                                 .capture_time = RoomTime(SteadyClock().now().time_since_epoch()),
                                 .base_seq = seq};
  std::vector<std::uint8_t> bytes(wire::kFrameHeaderBytes);
  wire::write_frame_header(header, std::span(bytes).first<wire::kFrameHeaderBytes>());
  return net::frame_message(net::MessageBuffer(bytes));
}

inline pb::Control join_as_viewer() {
  pb::Control control;
  control.mutable_join()->mutable_viewer();
  return control;
}

class HubServerTest : public testing::Test {
 protected:
  explicit HubServerTest(HubOptions options = {}) {
    options.port = 0;
    hub = std::move(*HubServer::open(options));
    thread = std::jthread([this](const std::stop_token& stop) { hub->run(stop); });
  }
  ~HubServerTest() override {
    if (!thread.joinable()) return;
    thread.request_stop();
    io.run_for(100ms);  // so that the clients answer the hub's close frames
    thread.join();
  }

  /// A connected client that sends this message first.
  std::shared_ptr<RawClient> connect(const pb::Control& first) {
    return connect(std::deque{framed_control(first)});
  }
  std::shared_ptr<RawClient> connect(std::deque<net::FramedMessagePtr> to_send) {
    auto client = std::make_shared<RawClient>(std::move(to_send));
    const net::HubUrl url{.host = "127.0.0.1", .port = hub->port()};
    bool answered = false;
    net::connect(io, url, {}, [&](auto connection) {
      answered = true;
      ASSERT_TRUE(connection.ok()) << connection.error().message;
      (*connection)->start(client);
      sockets.push_back(*connection);
    });
    run_until([&] { return answered; });
    return client;
  }

  void run_until(const std::function<bool()>& done) {
    io.restart();  // run_one_until() stops the loop when it has no work left
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    while (!done() && io.run_one_until(give_up) > 0) {
    }
    ASSERT_TRUE(done()) << "nothing happened in 5 s";
  }

  std::unique_ptr<HubServer> hub;
  std::jthread thread;
  boost::asio::io_context io;
  std::vector<std::shared_ptr<net::WebSocketConnection>> sockets;
};

}  // namespace roomcast::hub
