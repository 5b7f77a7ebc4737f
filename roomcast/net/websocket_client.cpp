// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/websocket_client.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <boost/asio/error.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>

#include "roomcast/net/host_lookup.h"
#include "roomcast/net/socket_tuning.h"
#include "roomcast/net/stream.h"
#include "roomcast/net/tls/tls_context.h"
#include "roomcast/net/websocket_handshake.h"

namespace roomcast::net {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using Tcp = asio::ip::tcp;
using SystemError = boost::system::error_code;

namespace {

constexpr std::uint32_t kMaxAnswerHeader = 8 * 1024;
/// A longer refusal does not come from a hub and is not read.
constexpr std::uint64_t kMaxRefusal = 512;

class Attempt final : public ConnectAttempt, public std::enable_shared_from_this<Attempt> {
 public:
  Attempt(asio::io_context& io, const HubUrl& url, ClientOptions options, ConnectCallback callback)
      : resolver_(io),
        deadline_(io),
        socket_(io),
        url_(url),
        where_(host_and_port(url)),
        options_(std::move(options)),
        callback_(std::move(callback)) {}

  void start();
  void cancel() override;

 private:
  void resolve();
  void on_resolved(SystemError error, const Tcp::resolver::results_type& endpoints);
  void connect_to(const Tcp::resolver::results_type& endpoints);
  void connect_to_next(SystemError last_error);
  void on_connected(SystemError error);
  void encrypt();
  void on_encrypted(SystemError error);
  void ask();
  void read_answer();
  void on_answer(SystemError error);
  void succeed();
  void refused();
  void fail(ErrorCode code, std::string sentence);
  void finish(Result<std::shared_ptr<WebSocketConnection>> result);

  /// Calls `next(*this, error)` unless the attempt has ended by then.
  template <class Next>
  auto then(Next next) {
    return [self = shared_from_this(), next](SystemError error, const auto&...) {
      if (self->callback_) next(*self, error);
    };
  }

  Tcp::resolver resolver_;
  asio::steady_timer deadline_;
  Tcp::socket socket_;            // while connecting...
  std::optional<Stream> stream_;  // ...and afterwards
  Tcp::resolver::results_type endpoints_;
  Tcp::resolver::results_type::const_iterator next_endpoint_;
  HubUrl url_;
  std::string where_;
  ClientOptions options_;
  ConnectCallback callback_;  // empty once the attempt has ended

  std::string key_ = random_key();
  EmptyRequest request_;
  beast::flat_buffer buffer_{kMaxAnswerHeader + kMaxRefusal};
  http::response_parser<http::string_body> answer_;
};

void Attempt::start() {
  deadline_.expires_after(options_.connect_within);
  deadline_.async_wait(then([](Attempt& self, SystemError error) {
    if (error) return;
    self.fail(ErrorCode::kUnavailable,
              self.where_ + " did not answer in time; check the address and the network.");
  }));
  resolve();
}

void Attempt::resolve() {
  look_up(
      resolver_, url_.host, url_.port,
      [self = shared_from_this()](SystemError error, const Tcp::resolver::results_type& endpoints) {
        if (self->callback_) self->on_resolved(error, endpoints);
      });
}

void Attempt::on_resolved(SystemError error, const Tcp::resolver::results_type& endpoints) {
  if (!error) return connect_to(endpoints);
  fail(ErrorCode::kNotFound, "There is no host '" + url_.host + "'; check the hub's address.");
}

void Attempt::connect_to(const Tcp::resolver::results_type& endpoints) {
  endpoints_ = endpoints;
  next_endpoint_ = endpoints_.begin();
  connect_to_next(asio::error::host_not_found);
}

// Not asio::async_connect, which opens the sockets itself: the size of segments must be set between
// opening and connecting.
void Attempt::connect_to_next(SystemError last_error) {
  if (next_endpoint_ == endpoints_.end()) return on_connected(last_error);
  const Tcp::endpoint endpoint = *next_endpoint_++;
  SystemError error;
  socket_.close(error);
  socket_.open(endpoint.protocol(), error);
  if (error) return connect_to_next(error);
  if (options_.max_segment_bytes > 0) limit_segments(socket_, options_.max_segment_bytes);
  if (options_.pace_bytes_per_s > 0) set_pace(socket_, options_.pace_bytes_per_s);
  socket_.async_connect(endpoint, then([](Attempt& self, SystemError failure) {
                          failure ? self.connect_to_next(failure) : self.on_connected({});
                        }));
}

void Attempt::on_connected(SystemError error) {
  if (error == asio::error::connection_refused) {
    return fail(ErrorCode::kUnavailable,
                "No program listens at " + where_ + "; is the hub running?");
  }
  if (error) {
    return fail(ErrorCode::kUnavailable, where_ + " cannot be reached: " + error.message() + ".");
  }
  if (url_.tls) return encrypt();
  stream_.emplace(std::move(socket_));
  ask();
}

void Attempt::encrypt() {
  const auto context = TlsClientContext::create();
  if (!context) return fail(context.error().code, context.error().message);
  auto tls = TlsSession::connect(socket_.native_handle(), **context, {url_.host, url_.pinned});
  if (!tls) return fail(tls.error().code, tls.error().message);
  stream_.emplace(std::move(socket_), *std::move(tls));
  stream_->async_handshake(
      then([](Attempt& self, SystemError error) { self.on_encrypted(error); }));
}

void Attempt::on_encrypted(SystemError error) {
  if (!error) return ask();
  const std::string fault(stream_->tls_fault());
  if (fault.empty()) {
    return fail(ErrorCode::kUnavailable, where_ + " closed the connection without an answer.");
  }
  fail(ErrorCode::kUnsupported,
       where_ + " " + fault + "; ask the hub's operator for its address and fingerprint.");
}

void Attempt::ask() {
  request_ = make_upgrade_request(where_, url_.path, key_, options_.subprotocol);
  answer_.header_limit(kMaxAnswerHeader);
  answer_.body_limit(kMaxRefusal);
  http::async_write(*stream_, request_,
                    then([](Attempt& self, SystemError) { self.read_answer(); }));
}

/// Also after a failed write: reading then fails as well, and may reveal the reason.
void Attempt::read_answer() {
  http::async_read(*stream_, buffer_, answer_,
                   then([](Attempt& self, SystemError error) { self.on_answer(error); }));
}

void Attempt::on_answer(SystemError error) {
  if (!answer_.is_header_done()) {
    const bool closed =
        error == http::error::end_of_stream || error == asio::error::connection_reset;
    return fail(closed ? ErrorCode::kUnavailable : ErrorCode::kUnsupported,
                closed ? where_ + " closed the connection without an answer."
                       : where_ + " does not answer like a roomcast hub; check the port.");
  }
  if (answer_.get().result() != http::status::switching_protocols) return refused();
  if (const auto fault = fault_in_upgrade(answer_.get(), key_, options_.subprotocol)) {
    return fail(ErrorCode::kUnsupported,
                where_ + " " + *fault + "; is it a roomcast hub of this version?");
  }
  succeed();
}

void Attempt::succeed() {
  const auto received = buffer_.cdata();
  ConnectionOptions options;
  options.role = WebSocketRole::kClient;
  options.max_message_bytes = options_.max_message_bytes;
  options.timings = options_.timings;
  finish(std::make_shared<WebSocketConnection>(
      *std::move(stream_), std::move(options),
      std::span(static_cast<const std::uint8_t*>(received.data()), received.size())));
}

/// True for the answers of a full hub, or of a proxy whose hub is unreachable.
bool is_for_now(http::status status) {
  return status == http::status::service_unavailable || status == http::status::bad_gateway ||
         status == http::status::gateway_timeout;
}

/// Handles an ordinary HTTP answer. A hub explains a refusal in one line of plain text.
void Attempt::refused() {
  const auto& answer = answer_.get();
  const auto status = answer.result_int();
  std::string_view why = answer.body();
  while (why.ends_with('\n') || why.ends_with('\r')) why.remove_suffix(1);
  const bool one_line = std::ranges::all_of(why, [](char c) { return c >= ' ' && c < 0x7F; });
  const bool from_roomcast = one_line && !why.empty() && answer[http::field::server] == "roomcast";
  const bool later = is_for_now(answer.result());
  const std::string sentence =
      from_roomcast ? where_ + " refused the connection: " + std::string(why)
      : later       ? where_ + " is full or not ready; try again later."
                    : where_ + " answered with HTTP status " + std::to_string(status) +
                    " instead of a WebSocket; is it a roomcast hub?";
  fail(later ? ErrorCode::kUnavailable : ErrorCode::kUnsupported, sentence);
}

void Attempt::fail(ErrorCode code, std::string sentence) {
  finish(Error{code, std::move(sentence)});
}

void Attempt::finish(Result<std::shared_ptr<WebSocketConnection>> result) {
  const ConnectCallback callback = std::exchange(callback_, nullptr);
  cancel();
  callback(std::move(result));
}

void Attempt::cancel() {
  callback_ = nullptr;
  deadline_.cancel();
  resolver_.cancel();
  SystemError ignored;
  socket_.close(ignored);
  if (stream_) stream_->close();
}

}  // namespace

std::shared_ptr<ConnectAttempt> connect(asio::io_context& io, const HubUrl& url,
                                        ClientOptions options, ConnectCallback callback) {
  auto attempt = std::make_shared<Attempt>(io, url, std::move(options), std::move(callback));
  attempt->start();
  return attempt;
}

}  // namespace roomcast::net
