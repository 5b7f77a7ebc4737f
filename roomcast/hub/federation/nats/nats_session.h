// SPDX-License-Identifier: Apache-2.0
// NatsSession: one connection to one NATS server, from the moment it has let us in to its end.
// Messages are handed on where they were read, and long ones written from where they lie, unless
// they are encrypted; neither waits.
// Threading: lives on one io_context.
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
    std::function<void()> on_gone;  // once, unless it was stopped
  };

  /// On the io_context of the connection's stream.
  explicit NatsSession(NatsConnection connection);

  /// From now on messages come.
  void start(Handlers handlers);
  /// Nothing more comes, nothing more is written.
  void stop();

  void subscribe(const std::string& subject);
  void unsubscribe(const std::string& subject);
  /// False: it is not sent, because more than `max_waiting_bytes` wait for a slow server.
  bool publish(std::string_view subject, std::span<const std::uint8_t> message,
               std::size_t max_waiting_bytes);

  [[nodiscard]] std::size_t max_message_bytes() const { return info_.max_message_bytes; }
  /// As it was named, without user and password.
  [[nodiscard]] const std::string& server() const { return server_; }

  /// When the server last said something.
  [[nodiscard]] HostTime last_heard() const { return last_heard_; }
  /// It should say something.
  void ask() { write(kNatsPing); }
  /// It is gone soon: on_gone.
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
  HostTime last_heard_{};
  std::map<std::uint64_t, std::string> subscriptions_;  // subjects by number
  std::uint64_t newest_subscription_ = 0;

  std::vector<std::uint8_t> in_;           // of these bytes...
  std::size_t in_begin_ = 0, in_end_ = 0;  // ...those were read and not taken
  std::vector<std::uint8_t> waiting_;      // to be written
  bool is_over_ = false;                   // it was stopped, or this was told
};

}  // namespace roomcast::hub::federation
