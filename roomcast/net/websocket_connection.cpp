// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/websocket_connection.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>
#include <variant>

#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>

#include "roomcast/core/assert.h"
#include "roomcast/net/peer_name.h"
#include "roomcast/net/random_bytes.h"
#include "roomcast/net/socket_tuning.h"

namespace roomcast::net {

namespace asio = boost::asio;

namespace {

/// Idle connections keep a small read buffer; a connection that receives large messages, or many at
/// once, gets a larger one: a frame set then takes one read instead of one per frame.
constexpr std::size_t kMinReadBuffer = 4 * 1024;
constexpr std::size_t kMaxReadBuffer = 64 * 1024;

/// Bytes requested from the handler for one write. After a socket could not accept everything, it
/// is offered little at a time, so that waiting data stays in the handler, where it can still be
/// replaced, until the socket has caught up and the handler has no more.
constexpr std::size_t kCongestedPull = 16 * 1024;
constexpr std::size_t kMaxPull = 256 * 1024;

/// Delay up to which a timer counts as on time; some delay is normal on any machine.
constexpr std::chrono::milliseconds kOnTime{20};

std::string address_of(const asio::ip::tcp::socket& socket) {
  boost::system::error_code error;
  const auto endpoint = socket.remote_endpoint(error);
  if (error) return "unknown";
  std::ostringstream text;
  text << endpoint;
  return text.str();
}

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

WebSocketConnection::WebSocketConnection(Stream stream, ConnectionOptions options,
                                         std::span<const std::uint8_t> received)
    : stream_(std::move(stream)),
      timer_(stream_.get_executor()),
      options_(std::move(options)),
      peer_address_(address_of(stream_.socket())),
      peer_(peer_name(stream_.socket())),
      reader_(options_.role, options_.max_message_bytes),
      received_before_start_(received.begin(), received.end()),
      pull_limit_bytes_(kMaxPull) {
  tune_for_live_streams(stream_.socket());
}

void WebSocketConnection::start(std::shared_ptr<ConnectionHandler> handler) {
  ROOMCAST_ASSERT(handler != nullptr && handler_ == nullptr);
  handler_ = std::move(handler);
  last_heard_ = std::chrono::steady_clock::now();
  if (stage_ == Stage::kOpen) watch_silence();
  asio::post(stream_.get_executor(), [self = shared_from_this()] {
    self->take(std::exchange(self->received_before_start_, {}));
    self->read();
  });
  schedule_write();
}

void WebSocketConnection::wake() {
  handler_has_no_message_ = false;
  if (pulling_) return;
  if (handler_ == nullptr || write_scheduled_) return schedule_write();
  write();
}

void WebSocketConnection::close(std::uint16_t code, std::string sentence) {
  close_after(nullptr, code, std::move(sentence));
}

void WebSocketConnection::close_after(FramedMessagePtr last, std::uint16_t code,
                                      std::string sentence) {
  if (stage_ != Stage::kOpen) return;
  stage_ = Stage::kClosing;
  if (last != nullptr) push_message(std::move(last));
  push_close(code, sentence);
  reason_ = {code, std::move(sentence), false};
  bound_closing();
}

// ---- reading

void WebSocketConnection::read() {
  if (stage_ == Stage::kClosed) return;
  const auto useful = std::max<std::uint64_t>(reader_.missing_bytes(), read_ahead_bytes_);
  const auto wanted =
      static_cast<std::size_t>(std::clamp<std::uint64_t>(useful, kMinReadBuffer, kMaxReadBuffer));
  if (read_buffer_.size() < wanted) read_buffer_ = std::vector<std::uint8_t>(wanted);
  stream_.async_read_some(asio::buffer(read_buffer_),
                          [self = shared_from_this()](ErrorCode error, std::size_t size) {
                            self->on_read(error, size);
                          });
}

void WebSocketConnection::on_read(ErrorCode error, std::size_t size) {
  if (stage_ == Stage::kClosed) return;
  if (error) return on_broken(error);
  heard_from_peer();
  if (size == read_buffer_.size()) read_ahead_bytes_ = 2 * size;  // there may be more
  take(std::span(read_buffer_).first(size));
  read();
}

void WebSocketConnection::take(std::span<const std::uint8_t> bytes) {
  counters_.bytes_in += bytes.size();
  while (!bytes.empty() && stage_ != Stage::kClosed) {
    ReaderEvent event = reader_.next(bytes);
    std::visit([this](auto&& what) { take_event(std::move(what)); }, std::move(event));
  }
  if (stage_ == Stage::kOpen) handler_->on_read_done();
}

void WebSocketConnection::take_event(MessageBuffer message) {
  ++counters_.messages_in;
  if (stage_ == Stage::kOpen) handler_->on_message(std::move(message));
}

void WebSocketConnection::take_event(Ping ping) {
  if (stage_ != Stage::kOpen) return;
  unanswered_ping_ = std::move(ping);
  schedule_write();
}

void WebSocketConnection::take_event(const PeerClose& close) {
  const bool ours_is_on_its_way = stage_ == Stage::kClosing;
  stage_ = Stage::kAnswering;
  if (ours_is_on_its_way) return schedule_write();
  reason_ = {close.code, close.reason, true};
  push_close(close.code == close_code::kNoCode ? close_code::kNormal : close.code, "");
  bound_closing();
  report(reason_);
}

void WebSocketConnection::take_event(Violation violation) {
  const bool ours_is_on_its_way = stage_ == Stage::kClosing;
  stage_ = Stage::kAnswering;  // the reader has stopped, so no answer can be read
  if (ours_is_on_its_way) return schedule_write();
  push_close(violation.code, violation.sentence);
  reason_ = {violation.code, std::move(violation.sentence), false};
  bound_closing();
}

// ---- writing

void WebSocketConnection::schedule_write() {
  if (write_scheduled_ || waiting_until_writable_) return;
  write_scheduled_ = true;
  asio::post(stream_.get_executor(), [self = shared_from_this()] {
    self->write_scheduled_ = false;
    self->write();
  });
}

void WebSocketConnection::write() {
  const bool ended = stage_ == Stage::kDraining || stage_ == Stage::kClosed;
  if (ended || waiting_until_writable_ || write_failed_) return;
  if (outgoing_.empty() && !refill()) return;
  if (outgoing_.empty()) return on_all_written();
  ErrorCode error;
  const auto buffers = outgoing_.gather();
  const std::size_t offered = asio::buffer_size(buffers);
  const std::size_t size = stream_.write_some(buffers, error);
  if (error && error != asio::error::would_block) return on_write_failed();
  on_wrote(size, offered);
}

/// After everything is written, collects the next data. False: wait until the socket is writable.
bool WebSocketConnection::refill() {
  if (pull_limit_bytes_ < kMaxPull && !stream_.is_writable_now()) {
    wait_until_writable();
    return false;
  }
  if (unanswered_ping_ && stage_ == Stage::kOpen) {
    push_control(Opcode::kPong, bytes_of(unanswered_ping_->payload));
    unanswered_ping_.reset();
  }
  pull();
  return true;
}

void WebSocketConnection::pull() {
  while (stage_ == Stage::kOpen && handler_ != nullptr && !handler_has_no_message_ &&
         outgoing_.count() < OutgoingFrames::kMaxGather &&
         outgoing_.unwritten_bytes() < pull_limit_bytes_) {
    handler_has_no_message_ = true;  // before the call, which may call wake()
    pulling_ = true;
    FramedMessagePtr message = handler_->next_message();
    pulling_ = false;
    if (message == nullptr) {
      pull_limit_bytes_ = kMaxPull;
      if (!handler_has_no_message_) schedule_write();
      return;
    }
    handler_has_no_message_ = false;
    if (stage_ == Stage::kOpen) push_message(std::move(message));
  }
}

void WebSocketConnection::on_wrote(std::size_t size, std::size_t offered) {
  counters_.bytes_out += size;
  outgoing_.wrote(size);
  if (size < offered) {
    pull_limit_bytes_ = kCongestedPull;
    return wait_until_writable();
  }
  const bool more = !outgoing_.empty() || unanswered_ping_ || !handler_has_no_message_;
  if (more || stage_ != Stage::kOpen) schedule_write();
}

void WebSocketConnection::wait_until_writable() {
  waiting_until_writable_ = true;
  stream_.async_wait_writable([self = shared_from_this()](ErrorCode error) {
    self->waiting_until_writable_ = false;
    if (error || self->stage_ == Stage::kClosed) return;
    self->heard_from_peer();  // the peer has acknowledged data, since there is space again
    self->write();
  });
}

void WebSocketConnection::push_control(Opcode opcode, std::span<const std::uint8_t> payload) {
  std::optional<MaskKey> mask;
  if (options_.role == WebSocketRole::kClient) fill_with_random_bytes(mask.emplace());
  outgoing_.push(frame_message(MessageBuffer(payload), opcode, mask));
}

void WebSocketConnection::push_message(FramedMessagePtr message) {
  ++counters_.messages_out;
  if (options_.role == WebSocketRole::kServer) return outgoing_.push(std::move(message));
  MaskKey mask{};
  fill_with_random_bytes(mask);
  outgoing_.push(frame_masked_copy(*message, mask));
}

void WebSocketConnection::push_close(std::uint16_t code, std::string_view reason) {
  ROOMCAST_ASSERT(may_be_sent(code));
  const std::array code_bytes = {static_cast<std::uint8_t>(code >> 8),
                                 static_cast<std::uint8_t>(code)};
  MessageBuffer payload(code_bytes);
  payload.append(bytes_of(cut_close_reason(reason)));
  push_control(Opcode::kClose, payload.payload());
  schedule_write();
}

// ---- time

void WebSocketConnection::heard_from_peer() {
  last_heard_ = std::chrono::steady_clock::now();
  ping_sent_ = false;
}

void WebSocketConnection::watch_silence() {
  const auto& timings = options_.timings;
  const SteadyTime now = std::chrono::steady_clock::now();
  const SteadyTime next_look =
      ping_sent_ ? now + timings.ping_after : last_heard_ + timings.ping_after;
  timer_.expires_at(std::min(next_look, last_heard_ + timings.give_up_after));
  timer_.async_wait([self = shared_from_this()](ErrorCode error) {
    if (!error && self->stage_ == Stage::kOpen) self->on_silence_timer();
  });
}

void WebSocketConnection::set_timings(const ConnectionTimings& timings) {
  options_.timings = timings;
  if (stage_ == Stage::kOpen && handler_) watch_silence();
}

std::optional<LineState> WebSocketConnection::line_state() {
  if (!stream_.is_open()) return std::nullopt;
  auto state = net::line_state(stream_.socket().native_handle());
  if (state) state->unsent_bytes += unwritten_bytes();
  return state;
}

void WebSocketConnection::set_pace(double payload_bytes_per_s) {
  if (stream_.is_open()) net::set_pace(stream_.socket(), payload_bytes_per_s);
}

/// A late timer means that this program was kept from reading as well; messages of the peer may
/// still be unread, so the delay does not count as silence.
void WebSocketConnection::on_silence_timer() {
  const SteadyTime now = std::chrono::steady_clock::now();
  if (const auto late = now - timer_.expiry(); late > kOnTime)
    last_heard_ = std::min(now, last_heard_ + late);
  const auto silence = now - last_heard_;
  if (silence >= options_.timings.give_up_after) {
    return shut({close_code::kAbnormal, "The other side was silent for too long.", false});
  }
  if (silence >= options_.timings.ping_after && !ping_sent_) {
    ping_sent_ = true;
    // Data being written serves as the probe: it proceeds only if the peer acknowledges.
    if (outgoing_.empty()) push_control(Opcode::kPing, {});
    schedule_write();
  }
  watch_silence();
}

void WebSocketConnection::bound_closing() {
  timer_.expires_after(options_.timings.close_within);
  timer_.async_wait([self = shared_from_this()](ErrorCode error) {
    if (!error) self->shut(self->reason_);
  });
}

// ---- the end

/// Reading continues: the peer may have sent a reason before it disconnected.
void WebSocketConnection::on_write_failed() {
  write_failed_ = true;
  outgoing_.clear();
  if (stage_ != Stage::kOpen) return;
  reason_ = {close_code::kAbnormal, "The connection was lost.", true};
  bound_closing();
}

void WebSocketConnection::on_all_written() {
  if (stage_ != Stage::kAnswering) return;
  stage_ = Stage::kDraining;
  stream_.shutdown_send();
  report(reason_);
}

void WebSocketConnection::on_broken(ErrorCode error) {
  if (stage_ != Stage::kOpen) return shut(reason_);
  shut({close_code::kAbnormal,
        error == asio::error::eof ? "The connection ended without a close frame."
                                  : "The connection was lost: " + error.message() + ".",
        true});
}

void WebSocketConnection::report(CloseReason reason) {
  if (const auto handler = std::exchange(handler_, nullptr)) handler->on_closed(reason);
}

void WebSocketConnection::shut(CloseReason reason) {
  if (stage_ == Stage::kClosed) return;
  stage_ = Stage::kClosed;
  timer_.cancel();
  stream_.close();
  outgoing_.clear();
  options_.lease.reset();
  options_.place.reset();
  report(std::move(reason));
}

}  // namespace roomcast::net
