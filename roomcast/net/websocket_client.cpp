// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/websocket_client.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>

#include "roomcast/net/stream.h"
#include "roomcast/net/websocket_handshake.h"

namespace roomcast::net {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using SystemError = boost::system::error_code;

namespace {

constexpr std::uint32_t kMaxAnswerHeader = 8 * 1024;
/// A longer refusal does not come from a hub and is not read.
constexpr std::uint64_t kMaxRefusal = 512;

class Attempt final : public ConnectAttempt, public std::enable_shared_from_this<Attempt> {
 public:
  Attempt(asio::io_context& io, const HubUrl& url, ClientOptions options, ConnectCallback callback)
      : io_(io),
        deadline_(io),
        url_(url),
        where_(host_and_port(url)),
        options_(std::move(options)),
        callback_(std::move(callback)) {}

  void start();
  void cancel() override;

 private:
  void on_open(Result<Stream> stream);
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

  asio::io_context& io_;
  asio::steady_timer deadline_;
  std::shared_ptr<ConnectAttempt> opening_;  // while connecting...
  std::optional<Stream> stream_;             // ...and afterwards
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
  opening_ = open_stream(io_, url_, {options_.max_segment_bytes, options_.pace_bytes_per_s},
                         [self = shared_from_this()](Result<Stream> stream) {
                           if (self->callback_) self->on_open(std::move(stream));
                         });
}

void Attempt::on_open(Result<Stream> stream) {
  if (!stream) return finish(stream.error());
  stream_.emplace(*std::move(stream));
  ask();
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
  if (opening_) opening_->cancel();
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
