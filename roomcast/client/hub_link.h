// SPDX-License-Identifier: Apache-2.0
// HubLink: a client's connection to its hub, for sensors and viewers alike. It joins, synchronizes
// the clock, and reconnects when the connection breaks or the hub falls silent, at another hub if
// there are several, until the hub refuses it for good.
// Threading: lives on one io_context; everything, including the events, happens on the thread that
// runs it.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <boost/asio/io_context.hpp>

#include "roomcast/client/clock_sync.h"
#include "roomcast/client/hub_choice.h"
#include "roomcast/client/ping_schedule.h"
#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/net/hub_url.h"
#include "roomcast/net/line_state.h"
#include "roomcast/net/socket_tuning.h"
#include "roomcast/net/timer.h"
#include "roomcast/net/websocket_client.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::client {

class HubLinkEvents {
 public:
  virtual ~HubLinkEvents() = default;
  /// A new connection: all state of the previous one is invalid.
  virtual void on_welcome(const wire::pb::Welcome& welcome) = 0;
  /// A message that the link does not handle itself.
  virtual void on_control(const wire::pb::Control& message) = 0;
  virtual void on_frame(net::MessageBuffer message) = 0;
  /// Somebody's voice, for clients that join as listeners (wire.md section 6).
  virtual void on_audio(net::MessageBuffer message) { (void)message; }
  /// No more messages are in the data read so far.
  virtual void on_frames_done() {}
  /// The next frame to send, null for none; asked again after wake().
  virtual net::FramedMessagePtr next_frame() = 0;
  /// A better estimate of room time.
  virtual void on_clock(const ClockEstimate& estimate) = 0;
  /// There is no connection now. `final`: the hub refused it for good, and the reason says why;
  /// else the link keeps trying.
  virtual void on_down(const Error& reason, bool final) = 0;
};

class HubLink {
 public:
  /// The hub has a ping to answer at least twice a second. If nothing arrives for this long, the
  /// hub is gone although the connection was not closed (a cable pulled, a suspended machine).
  static constexpr net::ConnectionTimings kTimings{.ping_after = std::chrono::seconds(3),
                                                   .give_up_after = std::chrono::seconds(8)};
  /// Shorter timeouts if there is another hub to switch to. A live hub answers within milliseconds,
  /// even a busy one (established connections have priority), and the travel time of its answers is
  /// added to the timeout; after a wrong decision the client continues elsewhere with a new key
  /// frame.
  static constexpr net::ConnectionTimings kTimingsWithOthers{
      .ping_after = std::chrono::milliseconds(250),
      .give_up_after = std::chrono::milliseconds(700)};

  struct Options {
    std::optional<net::ConnectionTimings> timings = {};  // override the above
    std::optional<PingSchedule::Rhythm> pings = {};      // overrides that of the role
    std::optional<net::Pace> pace = {};                  // of what is sent
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
  /// Leaves cleanly; afterwards the io_context runs out of work.
  void stop();
  /// Signals that next_frame() has a frame.
  void wake();
  /// Dropped if there is no connection, or if too many messages are queued.
  void send(const wire::pb::Control& message);
  /// Nothing without a connection.
  [[nodiscard]] std::optional<net::LineState> line_state() const;
  /// Of this connection, until it ends.
  void set_pace(double payload_bytes_per_s);
  /// Bytes of all messages that were sent besides frames. Thread-safe.
  [[nodiscard]] std::uint64_t control_bytes() const { return control_bytes_; }

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
  const std::optional<net::Pace> pace_;
  std::atomic<std::uint64_t> control_bytes_{0};
  SteadyClock clock_;
  ClockSync clock_sync_;
  std::shared_ptr<Connection> connection_;                      // null without a connection
  std::vector<std::shared_ptr<net::ConnectAttempt>> attempts_;  // pending connection attempts
  std::size_t unanswered_ = 0;                                  // attempts that have not failed yet
  net::Timer retry_timer_;
  net::Timer ping_timer_;
  PingSchedule ping_schedule_;
  bool was_welcome_ = false;             // ever, on any connection
  std::optional<HostTime> welcomed_at_;  // on the current connection
  std::optional<Error> refusal_;         // the error that the hub sent before it closed
  wire::pb::ErrorCode refusal_code_ = wire::pb::ERROR_UNSPECIFIED;
};

}  // namespace roomcast::client
