// SPDX-License-Identifier: Apache-2.0
// HubLink: a client's connection to its hub: joins, keeps the clock, and comes back when the
// connection breaks or the hub falls silent, at the next one where there are several, until the hub
// refuses it for good. What sensors and viewers have in common.
// Threading: lives on one io_context; everything, the events too, happens on the thread that runs
// it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

#include "roomcast/client/clock_sync.h"
#include "roomcast/client/hub_choice.h"
#include "roomcast/client/ping_schedule.h"
#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/net/hub_url.h"
#include "roomcast/net/websocket_client.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::client {

class HubLinkEvents {
 public:
  virtual ~HubLinkEvents() = default;
  /// A new connection: everything starts anew.
  virtual void on_welcome(const wire::pb::Welcome& welcome) = 0;
  /// Any other message that the link does not deal with itself.
  virtual void on_control(const wire::pb::Control& message) = 0;
  virtual void on_frame(net::MessageBuffer message) = 0;
  /// Nothing more came with these frames.
  virtual void on_frames_done() {}
  /// The next frame to send, null for none; asked again after wake().
  virtual net::FramedMessagePtr next_frame() = 0;
  /// A better idea of room time.
  virtual void on_clock(const ClockEstimate& estimate) = 0;
  /// No connection now. `final`: and there will be none, the hub said why; else the link goes on
  /// trying.
  virtual void on_down(const Error& reason, bool final) = 0;
};

class HubLink {
 public:
  /// Twice a second and more the hub has a question to answer: when nothing comes for this long, it
  /// is gone although nobody said so (a cable pulled, a machine that sleeps).
  static constexpr net::ConnectionTimings kTimings{.ping_after = std::chrono::seconds(3),
                                                   .give_up_after = std::chrono::seconds(8)};
  /// Where there is another hub to go on at, nobody has to wait long for one that hangs. A hub that
  /// is there answers within milliseconds, also a busy one (who is inside is served first), and
  /// what its answers take on a long way is added; who was wrong goes on elsewhere with a new key
  /// frame.
  static constexpr net::ConnectionTimings kTimingsWithOthers{
      .ping_after = std::chrono::milliseconds(250),
      .give_up_after = std::chrono::milliseconds(700)};

  struct Options {
    std::optional<net::ConnectionTimings> timings = {};  // other ones than the above
    std::optional<PingSchedule::Rhythm> pings = {};      // another one than goes with the role
  };

  /// At least one hub.
  HubLink(boost::asio::io_context& io, std::vector<net::HubUrl> hubs, wire::pb::Join join,
          HubLinkEvents& events, const Options& options);
  HubLink(boost::asio::io_context& io, std::vector<net::HubUrl> hubs, wire::pb::Join join,
          HubLinkEvents& events)
      : HubLink(io, std::move(hubs), std::move(join), events, Options{}) {}
  ~HubLink();
  HubLink(const HubLink&) = delete;
  HubLink& operator=(const HubLink&) = delete;

  void start();
  /// Leaves in good order; the io_context runs out of work when it is done.
  void stop();
  /// next_frame() has something.
  void wake();
  /// Dropped when there is no connection, or when too many wait.
  void send(const wire::pb::Control& message);

 private:
  class Connection;

  void connect();
  void on_answer(const net::HubUrl& hub,
                 const Result<std::shared_ptr<net::WebSocketConnection>>& connection);
  void on_connected(const std::shared_ptr<net::WebSocketConnection>& connection);
  void on_nobody(const Error& reason);
  void on_ended(const net::CloseReason& reason);
  void retry_after(nanoseconds pause, const Error& reason);
  void connect_after(nanoseconds pause);
  void cancel_attempts();
  void ping_later();
  void ping();
  void take(net::MessageBuffer message);
  void take_control(std::span<const std::uint8_t> message);
  void keep_token(const wire::pb::Welcome& welcome);
  void take_pong(const wire::pb::ClockPong& pong);
  void give_up(const Error& reason);
  [[nodiscard]] bool is_over() const;
  [[nodiscard]] net::ConnectionTimings timings() const;

  boost::asio::io_context& io_;
  HubChoice hubs_;
  wire::pb::Join join_;
  HubLinkEvents& events_;
  const std::optional<net::ConnectionTimings> timings_;
  SteadyClock clock_;
  ClockSync clock_sync_;
  std::shared_ptr<Connection> connection_;                      // null while there is none
  std::vector<std::shared_ptr<net::ConnectAttempt>> attempts_;  // at hubs that are knocked at
  std::size_t unanswered_ = 0;                                  // of these
  boost::asio::steady_timer retry_timer_;
  boost::asio::steady_timer ping_timer_;
  PingSchedule ping_schedule_;
  bool was_welcome_ = false;             // on any connection
  std::optional<HostTime> welcomed_at_;  // on this one
  std::optional<Error> refusal_;         // what the hub said before it closed
  wire::pb::ErrorCode refusal_code_ = wire::pb::ERROR_UNSPECIFIED;
  bool stopped_ = false;
};

}  // namespace roomcast::client
