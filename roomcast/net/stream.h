// SPDX-License-Identifier: Apache-2.0
// Stream: a connected TCP socket, plain or with TLS, behind one interface. It never blocks: a call
// does what is possible now, or gives would_block and can be waited for. It is also an
// AsyncReadStream and AsyncWriteStream of Asio, for Beast's HTTP. At most one reader and one writer
// wait at a time; the stream must not be moved meanwhile. Threading: runs on its io_context's
// thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/compose.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>

#include "roomcast/net/tls/tls_session.h"

namespace roomcast::net {

class Stream {
 public:
  using Socket = boost::asio::ip::tcp::socket;
  using ErrorCode = boost::system::error_code;
  using executor_type = Socket::executor_type;

  /// `tls` must use this socket. The socket becomes non-blocking.
  explicit Stream(Socket socket, std::optional<TlsSession> tls = std::nullopt);

  [[nodiscard]] executor_type get_executor() { return socket_.get_executor(); }
  [[nodiscard]] Socket& socket() { return socket_; }
  [[nodiscard]] bool is_open() const { return socket_.is_open(); }

  /// Reads the bytes available now. Errors: would_block, eof, and the socket's own;
  /// connection_aborted if TLS failed, see tls_fault().
  std::size_t read_some(boost::asio::mutable_buffer into, ErrorCode& error);
  /// Writes as much of the front as is accepted now. After would_block the same bytes must be
  /// offered again.
  template <class ConstBuffers>
  std::size_t write_some(const ConstBuffers& from, ErrorCode& error);

  /// Waits until a write that gave would_block, or was incomplete, can continue.
  template <class Handler>
  void async_wait_writable(Handler handler) {
    socket_.async_wait(to_write_, std::move(handler));
  }
  /// Whether a write would accept bytes now.
  [[nodiscard]] bool is_writable_now();

  template <class MutableBuffers, class Token>
  auto async_read_some(const MutableBuffers& into, Token&& token);
  template <class ConstBuffers, class Token>
  auto async_write_some(const ConstBuffers& from, Token&& token);
  /// For a client, which so detects an untrusted server before it sends anything. Does nothing
  /// without TLS.
  template <class Token>
  auto async_handshake(Token&& token);

  /// Moves the stream to another thread's io_context; no operation may be pending. False: the
  /// socket is closed.
  [[nodiscard]] bool move_to(boost::asio::io_context& io);

  /// Announces that nothing more will be written.
  void shutdown_send();
  void close();

  [[nodiscard]] std::string_view tls_fault() const {
    return tls_ ? std::string_view(tls_->fault()) : std::string_view();
  }
  [[nodiscard]] bool peer_speaks_plain_http() const {
    return tls_ && tls_->peer_speaks_plain_http();
  }
  /// Writes past TLS, as much as is possible without waiting: for a peer that does not use TLS.
  void write_in_the_clear(std::string_view text);

 private:
  using Wait = Socket::wait_type;

  std::size_t step(TlsSession::Step step, Wait& direction, ErrorCode& error);
  std::size_t encrypt(std::span<const std::uint8_t> from, ErrorCode& error);
  void handshake(ErrorCode& error);

  /// Repeats `attempt` until it does not block.
  template <class Token, class Try>
  auto async_try(const Wait& direction, Try attempt, Token&& token);

  Socket socket_;
  std::optional<TlsSession> tls_;
  Wait to_read_ = Socket::wait_read;    // for reading: TLS may have to write first
  Wait to_write_ = Socket::wait_write;  // and the reverse
};

template <class ConstBuffers>
std::size_t Stream::write_some(const ConstBuffers& from, ErrorCode& error) {
  if (!tls_) return socket_.write_some(from, error);
  std::size_t written = 0;
  for (auto it = boost::asio::buffer_sequence_begin(from);
       it != boost::asio::buffer_sequence_end(from); ++it) {
    const boost::asio::const_buffer buffer(*it);
    const std::span bytes(static_cast<const std::uint8_t*>(buffer.data()), buffer.size());
    const std::size_t size = encrypt(bytes, error);
    written += size;
    if (size < bytes.size()) break;
  }
  if (written > 0) error = {};  // the error is reported by the next call
  return written;
}

template <class Token, class Try>
auto Stream::async_try(const Wait& direction, Try attempt, Token&& token) {
  // A success at the first attempt is posted: nothing may complete within the call that starts it.
  enum class Stage { kBegun, kTrying, kDone };
  return boost::asio::async_compose<Token, void(ErrorCode, std::size_t)>(
      [this, &direction, attempt, stage = Stage::kBegun, result = ErrorCode(),
       size = std::size_t{0}](auto& self, ErrorCode error = {}) mutable {
        if (stage == Stage::kDone) return self.complete(result, size);
        if (error) return self.complete(error, 0);
        size = attempt(result);
        if (result == boost::asio::error::would_block) {
          stage = Stage::kTrying;
          result = {};
          return socket_.async_wait(direction, std::move(self));
        }
        if (stage == Stage::kTrying) return self.complete(result, size);
        stage = Stage::kDone;
        boost::asio::post(socket_.get_executor(), std::move(self));
      },
      token, socket_);
}

template <class MutableBuffers, class Token>
auto Stream::async_read_some(const MutableBuffers& into, Token&& token) {
  const boost::asio::mutable_buffer first(*boost::asio::buffer_sequence_begin(into));
  // Asio's own read does not have to register with the kernel each time.
  if (!tls_) return socket_.async_read_some(first, std::forward<Token>(token));
  return async_try(
      to_read_, [this, first](ErrorCode& error) { return read_some(first, error); },
      std::forward<Token>(token));
}

template <class ConstBuffers, class Token>
auto Stream::async_write_some(const ConstBuffers& from, Token&& token) {
  return async_try(
      to_write_, [this, from](ErrorCode& error) { return write_some(from, error); },
      std::forward<Token>(token));
}

template <class Token>
auto Stream::async_handshake(Token&& token) {
  return async_try(
      to_write_,
      [this](ErrorCode& error) {
        handshake(error);
        return std::size_t{0};
      },
      std::forward<Token>(token));
}

}  // namespace roomcast::net
