// SPDX-License-Identifier: Apache-2.0
// NatsSession: one connection to one NATS server, driven by an event loop: libnats starts no
// threads for it that would have to be woken for every message. Threading: lives on one io_context;
// connect() waits, on any thread. Reading and writing do not wait, but over TLS: see
// NatsSessionThread.
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

/// A connection to one NATS server, from its connecting to its end.
class NatsServerLink {
 public:
  struct Handlers {
    std::function<void(std::vector<NatsMessagePtr>)> on_messages;
    std::function<void()> on_gone;  // once
  };

  virtual ~NatsServerLink() = default;
  /// From now on messages come.
  virtual void start(Handlers handlers) = 0;
  /// Nothing more comes, nothing more is written.
  virtual void stop() = 0;

  virtual void subscribe(const std::string& subject) = 0;
  virtual void unsubscribe(const std::string& subject) = 0;
  /// False: it is not sent, because more than `max_waiting_bytes` wait for a slow server.
  virtual bool publish(const std::string& subject, std::span<const std::uint8_t> message,
                       std::size_t max_waiting_bytes) = 0;

  [[nodiscard]] virtual std::size_t max_message_bytes() const = 0;
  /// As it was named, without user and password.
  [[nodiscard]] virtual std::string server() const = 0;

  /// When the server last said something.
  [[nodiscard]] virtual HostTime last_heard() const = 0;
  /// It should say something.
  virtual void ask() = 0;
  /// It is gone soon: on_gone.
  virtual void abort() = 0;
};

class NatsSession final : public NatsServerLink, public std::enable_shared_from_this<NatsSession> {
 public:
  /// Waits until there is a connection to the first of these servers that answers. Errors of
  /// libnats_options() and connect_error().
  static Result<std::shared_ptr<NatsSession>> connect(const NatsOptions& options,
                                                      boost::asio::io_context& io);
  ~NatsSession() override;

  void start(Handlers handlers) override;
  void stop() override;
  void subscribe(const std::string& subject) override;
  void unsubscribe(const std::string& subject) override;
  bool publish(const std::string& subject, std::span<const std::uint8_t> message,
               std::size_t max_waiting_bytes) override;
  [[nodiscard]] std::size_t max_message_bytes() const override;
  [[nodiscard]] std::string server() const override;
  /// Any thread.
  [[nodiscard]] HostTime last_heard() const override { return last_heard_; }
  void ask() override;
  void abort() override;
  /// Of its socket; whoever asks closes it.
  [[nodiscard]] int duplicate_socket();

 private:
  using ConnectionPtr = std::unique_ptr<natsConnection, decltype(&natsConnection_Destroy)>;
  using SubscriptionPtr = std::unique_ptr<natsSubscription, decltype(&natsSubscription_Destroy)>;

  explicit NatsSession(boost::asio::io_context& io) : socket_(io) {}

  static natsStatus attach(void** user_data, void* session, natsConnection*, natsSock fd);
  static natsStatus read_wanted(void*, bool) { return NATS_OK; }   // always
  static natsStatus write_wanted(void*, bool) { return NATS_OK; }  // after each call to libnats
  static natsStatus detach(void*) { return NATS_OK; }

  void close_now();
  void read_later();
  void read();
  void write();
  [[nodiscard]] std::vector<NatsMessagePtr> take_messages();
  bool end_if_closed();

  boost::asio::posix::stream_descriptor socket_;  // a duplicate: libnats closes its own
  ConnectionPtr connection_{nullptr, &natsConnection_Destroy};
  std::vector<std::pair<std::string, SubscriptionPtr>> subscriptions_;  // oldest first
  Handlers handlers_;
  SteadyClock clock_;
  std::atomic<HostTime> last_heard_{};
  bool waits_to_write_ = false;
  bool is_over_ = false;  // it was told
};

}  // namespace roomcast::cluster
