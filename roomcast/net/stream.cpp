// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/stream.h"

#include <sys/socket.h>

#include "roomcast/net/socket_tuning.h"

namespace roomcast::net {

namespace asio = boost::asio;

Stream::Stream(Socket socket, std::optional<TlsSession> tls)
    : socket_(std::move(socket)), tls_(std::move(tls)) {
  ErrorCode ignored;
  socket_.non_blocking(true, ignored);
}

std::size_t Stream::read_some(asio::mutable_buffer into, ErrorCode& error) {
  if (!tls_) return socket_.read_some(into, error);
  const std::span bytes(static_cast<std::uint8_t*>(into.data()), into.size());
  return step(tls_->read(bytes), to_read_, error);
}

std::size_t Stream::encrypt(std::span<const std::uint8_t> from, ErrorCode& error) {
  std::size_t written = 0;
  while (written < from.size()) {
    const std::size_t size = step(tls_->write(from.subspan(written)), to_write_, error);
    if (size == 0) break;
    written += size;
  }
  return written;
}

void Stream::handshake(ErrorCode& error) {
  error = {};
  if (tls_) step(tls_->handshake(), to_write_, error);
}

/// Translates the result of a TLS step: a byte count, or an error and the direction to wait for.
std::size_t Stream::step(TlsSession::Step step, Wait& direction, ErrorCode& error) {
  using Outcome = TlsSession::Outcome;
  error = {};
  switch (step.outcome) {
    case Outcome::kDone:
      return step.size;
    case Outcome::kWaitsToRead:
      direction = Socket::wait_read;
      error = asio::error::would_block;
      return 0;
    case Outcome::kWaitsToWrite:
      direction = Socket::wait_write;
      error = asio::error::would_block;
      return 0;
    case Outcome::kEnded:
      error = asio::error::eof;
      return 0;
    case Outcome::kFailed:
      error = asio::error::connection_aborted;
      return 0;
  }
  return 0;
}

bool Stream::move_to(asio::io_context& io) {
  ErrorCode error;
  const auto protocol = socket_.local_endpoint(error).protocol();
  if (error) return false;
  const auto descriptor = socket_.release(error);
  if (error) return false;
  socket_ = Socket(io, protocol, descriptor);
  socket_.non_blocking(true, error);
  return !error;
}

bool Stream::is_writable_now() {
  return net::is_writable_now(socket_);
}

void Stream::shutdown_send() {
  if (tls_) tls_->say_goodbye();
  ErrorCode ignored;
  socket_.shutdown(Socket::shutdown_send, ignored);
}

void Stream::close() {
  ErrorCode ignored;
  socket_.close(ignored);
}

void Stream::write_in_the_clear(std::string_view text) {
  (void)::send(socket_.native_handle(), text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
}

}  // namespace roomcast::net
