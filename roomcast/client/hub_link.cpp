// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/hub_link.h"

#include <deque>
#include <random>
#include <utility>

#include "roomcast/client/framed_control.h"
#include "roomcast/wire/control.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"

namespace roomcast::client {
namespace {

namespace pb = wire::pb;

/// A connection shorter than this counts as a failure: a client that is disconnected again and
/// again then backs off instead of returning every 250 ms.
constexpr std::chrono::seconds kSettled{5};

/// Errors after which a retry is useless: the same join would be refused again, or would displace
/// the client that replaced this one. An error after the welcome may be temporary (for example, a
/// hub that was suspended finds the client's clock far ahead of its own).
bool is_final(pb::ErrorCode code, bool had_been_welcomed) {
  if (code == pb::ERROR_REPLACED) return true;
  return !had_been_welcomed && code != pb::ERROR_ROOM_FULL && code != pb::ERROR_TOO_SLOW &&
         code != pb::ERROR_SHUTTING_DOWN && code != pb::ERROR_BUSY;
}

}  // namespace

// May outlive the link and then reports to nothing. The socket owns it, not vice versa.
class HubLink::Connection final : public net::ConnectionHandler {
 public:
  Connection(const std::shared_ptr<net::WebSocketConnection>& socket, HubLink& link)
      : socket_(socket), link_(&link) {}

  void on_message(net::MessageBuffer message) override {
    if (link_ != nullptr) link_->take(std::move(message));
  }
  void on_read_done() override {
    if (link_ != nullptr) link_->events_.on_frames_done();
  }
  net::FramedMessagePtr next_message() override {
    if (!control_.empty()) {
      auto message = std::move(control_.front());
      control_.pop_front();
      return message;
    }
    return link_ != nullptr ? link_->events_.next_frame() : nullptr;
  }
  void on_closed(const net::CloseReason& reason) override {
    if (link_ != nullptr) link_->on_ended(reason);
  }

  void send(const pb::Control& control) {
    if (control_.size() >= wire::kMaxQueuedControlMessages) return;
    control_.push_back(framed_control(control));
    if (link_ != nullptr) link_->control_bytes_ += control_.back()->size();
    wake();
  }
  void wake() {
    if (const auto socket = socket_.lock()) socket->wake();
  }
  void set_timings(const net::ConnectionTimings& timings) {
    if (const auto socket = socket_.lock()) socket->set_timings(timings);
  }
  [[nodiscard]] std::optional<net::LineState> line_state() const {
    const auto socket = socket_.lock();
    return socket ? socket->line_state() : std::nullopt;
  }
  void set_pace(double payload_bytes_per_s) {
    if (const auto socket = socket_.lock()) socket->set_pace(payload_bytes_per_s);
  }
  void part() {
    link_ = nullptr;
    if (const auto socket = socket_.lock()) socket->close(net::close_code::kNormal, "left");
  }

 private:
  std::weak_ptr<net::WebSocketConnection> socket_;
  HubLink* link_;
  std::deque<net::FramedMessagePtr> control_;
};

HubLink::HubLink(boost::asio::io_context& io, std::vector<net::HubUrl> hubs, pb::Join join,
                 HubLinkEvents& events, const Options& options)
    : io_(io),
      hubs_(std::move(hubs), std::random_device{}()),
      join_(std::move(join)),
      events_(events),
      timings_(options.timings),
      pace_(options.pace),
      retry_timer_(io),
      ping_timer_(io),
      ping_schedule_(options.pings.value_or(join_.has_sensor() ? PingSchedule::kOfSensor
                                                               : PingSchedule::kOfViewer),
                     std::random_device{}()) {}

HubLink::~HubLink() {
  stop();
}

void HubLink::start() {
  connect();
}

void HubLink::stop() {
  retry_timer_.stop();
  ping_timer_.stop();
  cancel_attempts();
  if (connection_) std::exchange(connection_, nullptr)->part();
}

void HubLink::wake() {
  if (connection_) connection_->wake();
}

void HubLink::send(const pb::Control& message) {
  if (connection_) connection_->send(message);
}

std::optional<net::LineState> HubLink::line_state() const {
  return connection_ ? connection_->line_state() : std::nullopt;
}

void HubLink::set_pace(double payload_bytes_per_s) {
  if (connection_) connection_->set_pace(payload_bytes_per_s);
}

net::ConnectionTimings HubLink::timings() const {
  if (timings_) return *timings_;
  if (!hubs_.has_others()) return kTimings;
  net::ConnectionTimings timings = kTimingsWithOthers;
  if (const auto clock = clock_sync_.estimate())
    timings.give_up_after += std::chrono::ceil<std::chrono::milliseconds>(2 * clock->error);
  timings.give_up_after = std::min(timings.give_up_after, kTimings.give_up_after);
  return timings;
}

void HubLink::connect() {
  net::ClientOptions options;
  options.max_message_bytes = wire::kMaxFrameBytes;
  options.timings = timings();
  if (pace_) {
    options.max_segment_bytes = pace_->segment_bytes;
    options.pace_bytes_per_s = pace_->payload_bytes_per_s;
  }
  const auto hubs = hubs_.to_try();
  unanswered_ = hubs.size();
  for (const net::HubUrl& hub : hubs) {
    attempts_.push_back(net::connect(io_, hub, options,
                                     [this, hub](auto connection) { on_answer(hub, connection); }));
  }
}

void HubLink::on_answer(const net::HubUrl& hub,
                        const Result<std::shared_ptr<net::WebSocketConnection>>& connection) {
  if (!connection) {
    if (--unanswered_ > 0) return;
    attempts_.clear();
    return on_nobody(connection.error());
  }
  hubs_.answered(hub);
  cancel_attempts();
  on_connected(*connection);
}

void HubLink::cancel_attempts() {
  for (const auto& attempt : std::exchange(attempts_, {})) attempt->cancel();
}

// A server that does not answer like a hub is not a hub, and a retry is useless. After a welcome,
// however, such an answer comes from a reverse proxy whose hub restarts.
void HubLink::on_nobody(const Error& reason) {
  const bool is_no_hub =
      reason.code == ErrorCode::kUnsupported && !was_welcome_ && !hubs_.has_others();
  if (is_no_hub) return give_up(reason);
  retry_after(hubs_.nobody_answered(), reason);
}

void HubLink::on_connected(const std::shared_ptr<net::WebSocketConnection>& connection) {
  clock_sync_ = {};
  ping_schedule_.start_anew();
  welcomed_at_.reset();
  refusal_.reset();
  connection_ = std::make_shared<Connection>(connection, *this);
  connection->start(connection_);
  pb::Control control;
  *control.mutable_join() = join_;
  connection_->send(control);
  // A hub that answers pings but no join has stopped working, or is none.
  retry_timer_.once(timings_.value_or(kTimings).give_up_after, [this] {
    connection_->part();
    on_ended({net::close_code::kNormal, "it does not answer"});
  });
}

void HubLink::on_ended(const net::CloseReason& reason) {
  connection_.reset();
  ping_timer_.cancel();
  const std::string sentence = refusal_ ? "the hub says: " + refusal_->message
                                        : "the connection to the hub ended: " + reason.sentence;
  const Error error{ErrorCode::kClosed, sentence};
  if (is_over()) return give_up(error);
  const nanoseconds pause = hubs_.failed();
  const bool is_redirected = refusal_ && refusal_code_ == pb::ERROR_BUSY && !welcomed_at_;
  if (is_redirected && pause == nanoseconds(0)) return connect_after(pause);  // not a failure
  retry_after(pause, error);
}

/// Whether the refusal is final. After an earlier welcome another hub may still accept this client.
bool HubLink::is_over() const {
  if (!refusal_ || !is_final(refusal_code_, welcomed_at_.has_value())) return false;
  return refusal_code_ == pb::ERROR_REPLACED || !was_welcome_ || !hubs_.has_others();
}

void HubLink::give_up(const Error& reason) {
  retry_timer_.stop();
  events_.on_down(reason, true);
}

void HubLink::retry_after(nanoseconds pause, const Error& reason) {
  connect_after(pause);
  events_.on_down(reason, false);  // must be last: it may call stop()
}

void HubLink::connect_after(nanoseconds pause) {
  retry_timer_.once(pause, [this] { connect(); });
}

void HubLink::ping_later() {
  ping_timer_.once(ping_schedule_.next(), [this] { ping(); });
}

void HubLink::ping() {
  pb::Control control;
  control.mutable_clock_ping()->set_client_ns(
      static_cast<std::uint64_t>(clock_.now().time_since_epoch().count()));
  send(control);
  ping_later();
}

void HubLink::take(net::MessageBuffer message) {
  const auto type = wire::message_type(message.payload());
  if (type && *type == wire::MessageType::kFrame) return events_.on_frame(std::move(message));
  if (type && *type == wire::MessageType::kAudio) return events_.on_audio(std::move(message));
  take_control(message.payload());
}

void HubLink::take_control(std::span<const std::uint8_t> message) {
  const auto control = wire::decode_control(
      message, join_.has_aligner() ? wire::Sender::kHubToAligner : wire::Sender::kHub);
  if (!control) return;  // of a later version, or damaged: ignored
  switch (control->message_case()) {
    case pb::Control::kWelcome:
      was_welcome_ = true;
      welcomed_at_ = clock_.now();
      retry_timer_.cancel();
      hubs_.welcomed();
      keep_token(control->welcome());
      join_.clear_redirected();
      events_.on_welcome(control->welcome());
      return ping();
    case pb::Control::kClockPong:
      return take_pong(control->clock_pong());
    case pb::Control::kError:
      refusal_ = Error{ErrorCode::kClosed, control->error().sentence()};
      refusal_code_ = control->error().code();
      if (refusal_code_ == pb::ERROR_BUSY) join_.set_redirected(true);
      return;
    case pb::Control::kOtherHubs:
      hubs_.learn({control->other_hubs().urls().begin(), control->other_hubs().urls().end()});
      return connection_->set_timings(timings());
    default:
      events_.on_control(*control);
  }
}

/// A code is valid once; the token that it was exchanged for serves for later joins.
void HubLink::keep_token(const pb::Welcome& welcome) {
  if (welcome.token().empty()) return;
  join_.set_token(welcome.token());
  join_.clear_code();
}

void HubLink::take_pong(const pb::ClockPong& pong) {
  const HostTime sent{nanoseconds(static_cast<std::int64_t>(pong.client_ns()))};
  const RoomTime hub{nanoseconds(static_cast<std::int64_t>(pong.hub_ns()))};
  const HostTime now = clock_.now();
  if (welcomed_at_ && now - *welcomed_at_ > kSettled) hubs_.settled();
  clock_sync_.add(sent, hub, now);
  if (const auto estimate = clock_sync_.estimate()) events_.on_clock(*estimate);
  if (connection_ && hubs_.has_others()) connection_->set_timings(timings());
}

}  // namespace roomcast::client
