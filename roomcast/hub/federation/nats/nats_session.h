// SPDX-License-Identifier: Apache-2.0
// NatsSession: one connection to one NATS server, from the login to its end. Received messages are
// passed on from the read buffer, and long messages are written from the caller's memory unless
// they are encrypted. It never blocks. Threading: runs on one io_context.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <boost/asio/buffer.hpp>

#include "roomcast/core/clock.h"
#include "roomcast/hub/federation/nats/nats_login.h"
#include "roomcast/hub/federation/nats/nats_protocol.h"

namespace roomcast::hub::federation {

class NatsSession final : public std::enable_shared_from_this<NatsSession> {
 public:
  struct Handlers {
    std::function<void(std::string_view subject, std::span<const std::uint8_t> message)> on_message;
    std::function<void()> on_lost;  // called once, unless stop() was called
  };

  /// Runs on the io_context of the connection's stream.
  explicit NatsSession(NatsConnection connection);

  /// Starts to receive messages.
  void start(Handlers handlers);
  /// Ends receiving and sending.
  void stop();

  void subscribe(const std::string& subject);
  void unsubscribe(const std::string& subject);
  /// False: not sent, because more than `max_waiting_bytes` wait for a slow server.
  bool publish(std::string_view subject, std::span<const std::uint8_t> message,
               std::size_t max_waiting_bytes);

  [[nodiscard]] std::size_t max_message_bytes() const { return info_.max_message_bytes; }
  /// As configured, without user and password.
  [[nodiscard]] const std::string& server() const { return server_; }

  /// Time of the server's last message.
  [[nodiscard]] HostTime last_received() const { return last_received_; }
  /// Sends a ping, which the server must answer.
  void ping() { write(kNatsPing); }
  /// Breaks the connection; on_lost follows.
  void abort();

 private:
  void make_room();
  void read_later();
  void read();
  void take(const NatsEvent& event);
  void end();
  void write(std::string_view line);
  void write(std::span<const boost::asio::const_buffer> pieces);
  void write_later();
  void write_waiting();

  net::Stream stream_;
  const bool is_encrypted_;
  NatsServerInfo info_;
  const std::string server_;
  Handlers handlers_;
  SteadyClock clock_;
  HostTime last_received_{};
  std::map<std::uint64_t, std::string> subscriptions_;  // subjects by number
  std::uint64_t newest_subscription_ = 0;

  std::vector<std::uint8_t> in_;           // read buffer...
  std::size_t in_begin_ = 0, in_end_ = 0;  // ...with the bytes read but not yet processed
  std::vector<std::uint8_t> waiting_;      // bytes to be written
  bool is_over_ = false;                   // stopped, or on_lost was called
};

}  // namespace roomcast::hub::federation
