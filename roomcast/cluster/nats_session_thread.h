// SPDX-License-Identifier: Apache-2.0
// NatsSessionThread: a NatsSession on a thread of its own, for encrypted connections: libnats waits
// for the rest of a record that has begun to come, and for room to write the rest of one, however
// long that takes, and the rooms must not wait with it. Messages come and go through both threads'
// event loops. Threading: as NatsSession, lives on the thread that runs `rooms`, which never waits
// for the other one but in stop(), and there at most kStopWithin.
#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <span>
#include <string>
#include <thread>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>

#include "roomcast/cluster/nats_session.h"

namespace roomcast::cluster {

class NatsSessionThread final : public NatsServerLink,
                                public std::enable_shared_from_this<NatsSessionThread> {
 public:
  static constexpr std::chrono::milliseconds kStopWithin{100};

  /// Errors of NatsSession::connect().
  static Result<std::shared_ptr<NatsServerLink>> connect(const NatsOptions& options,
                                                         boost::asio::io_context& rooms);
  ~NatsSessionThread() override;

  void start(Handlers handlers) override;
  void stop() override;
  void subscribe(const std::string& subject) override;
  void unsubscribe(const std::string& subject) override;
  bool publish(const std::string& subject, std::span<const std::uint8_t> message,
               std::size_t max_waiting_bytes) override;
  [[nodiscard]] std::size_t max_message_bytes() const override { return max_message_bytes_; }
  [[nodiscard]] std::string server() const override { return server_; }
  [[nodiscard]] HostTime last_heard() const override { return session_->last_heard(); }
  void ask() override;
  void abort() override;

 private:
  explicit NatsSessionThread(boost::asio::io_context& rooms) : rooms_(rooms) {}
  template <class Tell>
  void tell_rooms(Tell tell);

  boost::asio::io_context& rooms_;
  boost::asio::io_context own_{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> busy_ =
      boost::asio::make_work_guard(own_);
  std::shared_ptr<NatsSession> session_;  // used on its own thread, but for what may be asked here
  std::size_t max_message_bytes_ = 0;
  std::string server_;
  int socket_ = -1;  // a duplicate, to end what waits for it
  Handlers handlers_;
  std::atomic<std::size_t> waiting_bytes_ = 0;  // that the other thread has not taken yet
  bool is_stopped_ = false;
  std::jthread thread_;
};

/// One that nobody has to wait for: encrypted ones have a thread.
[[nodiscard]] Result<std::shared_ptr<NatsServerLink>> connect_to_nats(
    const NatsOptions& options, boost::asio::io_context& rooms);

}  // namespace roomcast::cluster
