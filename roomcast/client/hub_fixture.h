// SPDX-License-Identifier: Apache-2.0
// FakeHub: the hub of a client under test. Welcomes clients, records what they send, and sends what
// the test requests. Threading: lives on the thread that runs `io`.
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <gtest/gtest.h>

#include "roomcast/client/framed_control.h"
#include "roomcast/core/clock.h"
#include "roomcast/net/http_server.h"
#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/control.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"

namespace roomcast::client {

/// Asks again and again, up to 10 s.
template <class Condition>
[[nodiscard]] bool wait_until_true(Condition is_true) {
  using namespace std::chrono_literals;
  const HostTime give_up = SteadyClock().now() + 10s;
  while (!is_true() && SteadyClock().now() < give_up) std::this_thread::sleep_for(5ms);
  return is_true();
}

class FakeHub {
 public:
  explicit FakeHub(boost::asio::io_context& io, std::uint16_t port = 0) {
    net::HttpServerOptions options;
    options.port = port;
    options.max_message_bytes = wire::kMaxFrameBytes;
    options.on_websocket = [this](auto connection, std::size_t) {
      return accept(std::move(connection));
    };
    server_ = std::move(*net::HttpServer::listen(io, std::move(options)));
  }

  [[nodiscard]] std::uint16_t port() const { return server_->port(); }
  [[nodiscard]] std::string url() const { return "ws://127.0.0.1:" + std::to_string(port()); }

  /// Sends to the client that connected last.
  void say(net::FramedMessagePtr message) {
    to_say_->push_back(std::move(message));
    connection_->wake();
  }
  void say(const wire::pb::Control& control) { say(framed_control(control)); }
  void refuse(wire::pb::ErrorCode code, const std::string& sentence) {
    wire::pb::Control control;
    control.mutable_error()->set_code(code);
    control.mutable_error()->set_sentence(sentence);
    connection_->close_after(framed_control(control), net::close_code::kPolicy, sentence);
  }
  void hang_up() { connection_->close(net::close_code::kGoingAway, "the hub stops"); }

  std::vector<wire::pb::Control> heard;   // without pings, which are answered
  std::vector<wire::FrameHeader> frames;  // headers of published frames
  std::vector<wire::AudioHeader> voices;  // headers of what was said
  int joins = 0;
  std::function<void()> on_join = [] {};  // after the welcome
  std::optional<wire::pb::ErrorCode> refuse_joins_with;
  bool lets_joins_wait = false;
  bool lets_record = true, lets_export = true, lets_mark = true, lets_speak = false;
  std::chrono::nanoseconds clock_ahead{};  // offset of this hub's clock
  std::chrono::nanoseconds far_away{};     // simulated travel time of a ping and its answer

 private:
  using Messages = std::deque<net::FramedMessagePtr>;

  class Handler final : public net::ConnectionHandler {
   public:
    Handler(FakeHub& hub, std::shared_ptr<Messages> to_say)
        : hub_(hub), to_say_(std::move(to_say)) {}
    void on_message(net::MessageBuffer message) override { hub_.take(message.payload()); }
    net::FramedMessagePtr next_message() override {
      if (to_say_->empty()) return nullptr;
      auto message = to_say_->front();
      to_say_->pop_front();
      return message;
    }
    void on_closed(const net::CloseReason&) override {}

   private:
    FakeHub& hub_;
    std::shared_ptr<Messages> to_say_;
  };

  std::shared_ptr<net::ConnectionHandler> accept(
      std::shared_ptr<net::WebSocketConnection> connection) {
    connection_ = std::move(connection);
    to_say_ = std::make_shared<Messages>();
    return std::make_shared<Handler>(*this, to_say_);
  }

  void take(std::span<const std::uint8_t> message) {
    const wire::MessageType type = *wire::message_type(message);
    if (type == wire::MessageType::kFrame) return frames.push_back(*wire::parse_frame(message));
    if (type == wire::MessageType::kAudio) return voices.push_back(*wire::parse_audio(message));
    const auto control = *wire::decode_control(message, wire::Sender::kClient);
    if (control.has_clock_ping()) return answer(control.clock_ping());
    heard.push_back(control);
    if (!control.has_join() || lets_joins_wait) return;
    if (refuse_joins_with) return refuse(*refuse_joins_with, "no");
    welcome();
  }

  void answer(const wire::pb::ClockPing& ping) {
    wire::pb::Control pong;
    pong.mutable_clock_pong()->set_client_ns(ping.client_ns() -
                                             static_cast<std::uint64_t>(far_away.count()));
    const auto now = SteadyClock().now().time_since_epoch() + clock_ahead;
    pong.mutable_clock_pong()->set_hub_ns(static_cast<std::uint64_t>(now.count()));
    say(pong);
  }

  void welcome() {
    ++joins;
    wire::pb::Control control;
    control.mutable_welcome()->set_room("lab");
    control.mutable_welcome()->set_sensor_id(5);
    control.mutable_welcome()->set_may_record(lets_record);
    control.mutable_welcome()->set_may_export(lets_export);
    control.mutable_welcome()->set_may_place(true);
    control.mutable_welcome()->set_may_mark(lets_mark);
    control.mutable_welcome()->set_may_speak(lets_speak);
    say(control);
    on_join();
  }

  std::unique_ptr<net::HttpServer> server_;
  std::shared_ptr<net::WebSocketConnection> connection_;
  std::shared_ptr<Messages> to_say_;
};

}  // namespace roomcast::client
