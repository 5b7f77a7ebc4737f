// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/stream_client.h"

#include <optional>
#include <string>
#include <utility>

#include <boost/asio/error.hpp>
#include <boost/asio/ip/tcp.hpp>

#include "roomcast/net/host_lookup.h"
#include "roomcast/net/socket_tuning.h"
#include "roomcast/net/tls/tls_context.h"

namespace roomcast::net {
namespace {

namespace asio = boost::asio;
using Tcp = asio::ip::tcp;
using SystemError = boost::system::error_code;

class StreamAttempt final : public ConnectAttempt,
                            public std::enable_shared_from_this<StreamAttempt> {
 public:
  StreamAttempt(asio::io_context& io, const HubUrl& url, const StreamOptions& options,
                StreamCallback callback)
      : resolver_(io),
        socket_(io),
        url_(url),
        where_(host_and_port(url)),
        options_(options),
        callback_(std::move(callback)) {}

  void start();
  void cancel() override;

 private:
  void on_resolved(SystemError error, const Tcp::resolver::results_type& endpoints);
  void connect_to_next(SystemError last_error);
  void on_connected(SystemError error);
  void encrypt();
  void on_encrypted(SystemError error);
  void fail(ErrorCode code, std::string sentence);
  void finish(Result<Stream> result);

  /// Calls `next(*this, error)` unless the attempt has ended by then.
  template <class Next>
  auto then(Next next) {
    return [self = shared_from_this(), next](SystemError error, const auto&...) {
      if (self->callback_) next(*self, error);
    };
  }

  Tcp::resolver resolver_;
  Tcp::socket socket_;            // while connecting...
  std::optional<Stream> stream_;  // ...and afterwards
  Tcp::resolver::results_type endpoints_;
  Tcp::resolver::results_type::const_iterator next_endpoint_;
  HubUrl url_;
  std::string where_;
  StreamOptions options_;
  StreamCallback callback_;  // empty once the attempt has ended
};

void StreamAttempt::start() {
  look_up(
      resolver_, url_.host, url_.port,
      [self = shared_from_this()](SystemError error, const Tcp::resolver::results_type& endpoints) {
        if (self->callback_) self->on_resolved(error, endpoints);
      });
}

void StreamAttempt::on_resolved(SystemError error, const Tcp::resolver::results_type& endpoints) {
  if (error)
    return fail(ErrorCode::kNotFound,
                "There is no host '" + url_.host + "'; check the hub's address.");
  endpoints_ = endpoints;
  next_endpoint_ = endpoints_.begin();
  connect_to_next(asio::error::host_not_found);
}

// Not asio::async_connect, which opens the sockets itself: the size of segments must be set between
// opening and connecting.
void StreamAttempt::connect_to_next(SystemError last_error) {
  if (next_endpoint_ == endpoints_.end()) return on_connected(last_error);
  const Tcp::endpoint endpoint = *next_endpoint_++;
  SystemError error;
  socket_.close(error);
  socket_.open(endpoint.protocol(), error);
  if (error) return connect_to_next(error);
  if (options_.max_segment_bytes > 0) limit_segments(socket_, options_.max_segment_bytes);
  if (options_.pace_bytes_per_s > 0) set_pace(socket_, options_.pace_bytes_per_s);
  socket_.async_connect(endpoint, then([](StreamAttempt& self, SystemError failure) {
                          failure ? self.connect_to_next(failure) : self.on_connected({});
                        }));
}

void StreamAttempt::on_connected(SystemError error) {
  if (error == asio::error::connection_refused) {
    return fail(ErrorCode::kUnavailable,
                "No program listens at " + where_ + "; is the hub running?");
  }
  if (error) {
    return fail(ErrorCode::kUnavailable, where_ + " cannot be reached: " + error.message() + ".");
  }
  if (url_.tls) return encrypt();
  finish(Stream(std::move(socket_)));
}

void StreamAttempt::encrypt() {
  const auto context = TlsClientContext::create();
  if (!context) return fail(context.error().code, context.error().message);
  auto tls = TlsSession::connect(socket_.native_handle(), **context, {url_.host, url_.pinned});
  if (!tls) return fail(tls.error().code, tls.error().message);
  stream_.emplace(std::move(socket_), *std::move(tls));
  stream_->async_handshake(
      then([](StreamAttempt& self, SystemError error) { self.on_encrypted(error); }));
}

void StreamAttempt::on_encrypted(SystemError error) {
  if (!error) return finish(*std::exchange(stream_, std::nullopt));
  const std::string fault(stream_->tls_fault());
  if (fault.empty()) {
    return fail(ErrorCode::kUnavailable, where_ + " closed the connection without an answer.");
  }
  fail(ErrorCode::kUnsupported,
       where_ + " " + fault + "; ask the hub's operator for its address and fingerprint.");
}

void StreamAttempt::fail(ErrorCode code, std::string sentence) {
  finish(Error{code, std::move(sentence)});
}

void StreamAttempt::finish(Result<Stream> result) {
  const StreamCallback callback = std::exchange(callback_, nullptr);
  cancel();
  callback(std::move(result));
}

void StreamAttempt::cancel() {
  callback_ = nullptr;
  resolver_.cancel();
  SystemError ignored;
  socket_.close(ignored);
  if (stream_) stream_->close();
}

}  // namespace

std::shared_ptr<ConnectAttempt> open_stream(asio::io_context& io, const HubUrl& url,
                                            const StreamOptions& options, StreamCallback callback) {
  auto attempt = std::make_shared<StreamAttempt>(io, url, options, std::move(callback));
  attempt->start();
  return attempt;
}

}  // namespace roomcast::net
