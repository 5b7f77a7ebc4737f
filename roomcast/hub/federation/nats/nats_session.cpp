// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/nats/nats_session.h"

#include <algorithm>
#include <utility>

namespace roomcast::hub::federation {

namespace asio = boost::asio;

namespace {

/// Space for some frame sets of a room; grows for longer messages.
constexpr std::size_t kReadBytes = 256u << 10;
/// With less space a read might take only the beginning of the available bytes.
constexpr std::size_t kReadAtLeastBytes = 64u << 10;
/// Messages up to this size, and all encrypted ones, are copied behind their line: TLS would need
/// one record and one write per piece.
constexpr std::size_t kJoinedBytes = 4096;

}  // namespace

NatsSession::NatsSession(NatsConnection connection)
    : stream_(std::move(connection.stream)),
      is_encrypted_(connection.is_encrypted),
      info_(std::move(connection.info)),
      server_(std::move(connection.server)),
      last_received_(clock_.now()),
      in_(std::move(connection.received)),
      in_end_(in_.size()) {
  in_.resize(std::max(in_.size(), kReadBytes));
}

void NatsSession::start(Handlers handlers) {
  handlers_ = std::move(handlers);
  asio::post(stream_.get_executor(), [self = shared_from_this()] { self->read(); });
}

void NatsSession::stop() {
  is_over_ = true;
  stream_.shutdown_send();
  stream_.close();
}

/// The pending read then fails and ends the session.
void NatsSession::abort() {
  boost::system::error_code ignored;
  stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_both, ignored);
}

// ---- reading

void NatsSession::make_room() {
  if (in_begin_ == in_end_) in_begin_ = in_end_ = 0;
  if (in_.size() - in_end_ >= kReadAtLeastBytes) return;
  std::copy(in_.begin() + static_cast<std::ptrdiff_t>(in_begin_),
            in_.begin() + static_cast<std::ptrdiff_t>(in_end_), in_.begin());
  in_end_ -= std::exchange(in_begin_, 0);
  if (in_.size() - in_end_ < kReadAtLeastBytes) in_.resize(2 * in_.size());
}

void NatsSession::read_later() {
  make_room();
  stream_.async_read_some(
      asio::buffer(in_.data() + in_end_, in_.size() - in_end_),
      [self = shared_from_this()](boost::system::error_code error, std::size_t size) {
        if (self->is_over_) return;
        if (error) return self->end();
        self->in_end_ += size;
        self->last_received_ = self->clock_.now();
        self->read();
      });
}

void NatsSession::read() {
  while (!is_over_) {
    std::span<const std::uint8_t> bytes(in_.data() + in_begin_, in_end_ - in_begin_);
    const NatsEvent event = next_nats_event(bytes);
    if (std::holds_alternative<NatsNeedsMore>(event)) return read_later();
    if (std::holds_alternative<NatsViolation>(event)) return end();
    in_begin_ = in_end_ - bytes.size();
    take(event);
  }
}

/// Error messages are ignored: after serious ones the server disconnects.
void NatsSession::take(const NatsEvent& event) {
  if (const auto* message = std::get_if<NatsMessage>(&event)) {
    if (subscriptions_.contains(message->subscription)) {
      handlers_.on_message(message->subject, message->bytes);
    }
  } else if (std::holds_alternative<NatsPing>(event)) {
    write(kNatsPong);
  } else if (const auto* info = std::get_if<NatsInfo>(&event)) {
    info_ = read_server_info(info->json).value_or(info_);
  }
}

void NatsSession::end() {
  if (std::exchange(is_over_, true)) return;
  stream_.close();
  handlers_.on_lost();
}

// ---- writing

void NatsSession::subscribe(const std::string& subject) {
  subscriptions_[++newest_subscription_] = subject;
  write(subscribe_line(subject, newest_subscription_));
}

void NatsSession::unsubscribe(const std::string& subject) {
  std::erase_if(subscriptions_, [&](const auto& entry) {
    if (entry.second != subject) return false;
    write(unsubscribe_line(entry.first));
    return true;
  });
}

bool NatsSession::publish(std::string_view subject, std::span<const std::uint8_t> message,
                          std::size_t max_waiting_bytes) {
  if (waiting_.size() > max_waiting_bytes) return false;
  std::string line = publish_line(subject, message.size());
  if (is_encrypted_ || message.size() <= kJoinedBytes) {
    line.append(message.begin(), message.end()).append(kNatsLineEnd);
    write(line);
  } else {
    write(std::array<asio::const_buffer, 3>{asio::buffer(line),
                                            asio::buffer(message.data(), message.size()),
                                            asio::buffer(kNatsLineEnd)});
  }
  return true;
}

void NatsSession::write(std::string_view line) {
  write(std::array<asio::const_buffer, 1>{asio::buffer(line)});
}

/// Queues the bytes that are not accepted now.
void NatsSession::write(std::span<const asio::const_buffer> pieces) {
  if (is_over_) return;
  const bool waited = !waiting_.empty();
  boost::system::error_code error;
  std::size_t written = waited ? 0 : stream_.write_some(pieces, error);
  if (error && error != asio::error::would_block) return abort();
  for (const asio::const_buffer piece : pieces) {
    const std::size_t done = std::min(written, piece.size());
    written -= done;
    const auto* rest = static_cast<const std::uint8_t*>(piece.data());
    waiting_.insert(waiting_.end(), rest + done, rest + piece.size());
  }
  if (!waited && !waiting_.empty()) write_later();
}

void NatsSession::write_later() {
  stream_.async_wait_writable([self = shared_from_this()](boost::system::error_code error) {
    if (!error && !self->is_over_) self->write_waiting();
  });
}

void NatsSession::write_waiting() {
  boost::system::error_code error;
  const std::size_t written = stream_.write_some(asio::buffer(waiting_), error);
  if (error && error != asio::error::would_block) return abort();
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(written));
  if (!waiting_.empty()) write_later();
}

}  // namespace roomcast::hub::federation
