// SPDX-License-Identifier: Apache-2.0
// NatsSession: one connection to one NATS server, from its connecting to its end, driven by an
// event loop: libnats starts no threads for it that would have to be woken for every message.
// Threading: lives on one io_context; connect_session() waits, on any thread.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>

#include "roomcast/cluster/nats_options.h"
#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"

namespace roomcast::cluster {

using NatsMessagePtr = std::unique_ptr<natsMsg, decltype(&natsMsg_Destroy)>;

class NatsSession : public std::enable_shared_from_this<NatsSession> {
 public:
  struct Handlers {
    std::function<void(std::vector<NatsMessagePtr>)> on_messages;
    std::function<void()> on_gone;  // once
  };

  /// Waits until there is a connection to the first of these servers that answers. Errors of
  /// libnats_options() and connect_error().
  static Result<std::shared_ptr<NatsSession>> connect(const NatsOptions& options,
                                                      boost::asio::io_context& io);
  ~NatsSession();

  /// From now on messages come.
  void start(Handlers handlers);
  /// Nothing more comes, nothing more is written.
  void stop();

  void subscribe(const std::string& subject);
  void unsubscribe(const std::string& subject);
  /// False: it is not sent, because more than `max_waiting_bytes` wait for a slow server.
  bool publish(const std::string& subject, std::span<const std::uint8_t> message,
               std::size_t max_waiting_bytes);

  [[nodiscard]] std::size_t max_message_bytes() const;
  /// As it was named, without user and password.
  [[nodiscard]] std::string server() const;

  /// When the server last said something; it is asked to every kPingInterval.
  [[nodiscard]] HostTime last_heard() const { return last_heard_; }
  /// It is gone soon: on_gone.
  void abort();

 private:
  using ConnectionPtr = std::unique_ptr<natsConnection, decltype(&natsConnection_Destroy)>;
  using SubscriptionPtr = std::unique_ptr<natsSubscription, decltype(&natsSubscription_Destroy)>;

  explicit NatsSession(boost::asio::io_context& io) : io_(io), socket_(io) {}

  static natsStatus attach(void** user_data, void* session, natsConnection*, natsSock fd);
  static natsStatus read_wanted(void*, bool) { return NATS_OK; }  // always
  static natsStatus write_wanted(void* session, bool add);
  static natsStatus detach(void*) { return NATS_OK; }

  void close_now();
  void read_later();
  void read();
  void write();
  [[nodiscard]] std::vector<NatsMessagePtr> take_messages();
  bool end_if_closed();

  boost::asio::io_context& io_;
  boost::asio::posix::stream_descriptor socket_;  // a duplicate: libnats closes its own
  ConnectionPtr connection_{nullptr, &natsConnection_Destroy};
  std::vector<std::pair<std::string, SubscriptionPtr>> subscriptions_;  // oldest first
  Handlers handlers_;
  SteadyClock clock_;
  HostTime last_heard_{};
  std::atomic<bool> is_writing_ = false;  // libnats need not ask for it
  bool waits_to_write_ = false;
  bool is_over_ = false;  // it was told
};

}  // namespace roomcast::cluster
