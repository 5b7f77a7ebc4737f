// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/http_fetch.h"

#include <memory>
#include <optional>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>

#include "roomcast/net/stream_client.h"

namespace roomcast::net {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using SystemError = boost::system::error_code;

/// One request, on an io_context of its own that runs until the request has ended.
class Fetching {
 public:
  Fetching(const HubUrl& url, const std::string& target, const FetchOptions& options)
      : url_(url), where_(host_and_port(url)), deadline_(io_) {
    request_.method(http::verb::get);
    request_.target(target);
    request_.version(11);
    request_.set(http::field::host, where_);
    request_.set(http::field::connection, "close");
    if (!options.token.empty()) request_.set(http::field::authorization, "Bearer " + options.token);
    answer_.body_limit(options.max_bytes);
    deadline_.expires_after(options.within);
  }

  Result<FetchedAnswer> run(const std::stop_token& stop) {
    deadline_.async_wait([this](SystemError error) {
      if (!error) end(Error{ErrorCode::kUnavailable, where_ + " did not answer in time."});
    });
    opening_ = open_stream(io_, url_, {}, [this](Result<Stream> stream) {
      if (!stream) return end(stream.error());
      stream_.emplace(*std::move(stream));
      ask();
    });
    const std::stop_callback stopped(stop, [this] {
      asio::post(io_, [this] { end(Error{ErrorCode::kClosed, "stopped"}); });
    });
    io_.run();
    return *std::move(result_);
  }

 private:
  void ask() {
    http::async_write(*stream_, request_, [this](SystemError, std::size_t) {
      // Also after a failed write: reading then fails as well.
      http::async_read(*stream_, buffer_, answer_,
                       [this](SystemError error, std::size_t) { on_answer(error); });
    });
  }

  void on_answer(SystemError error) {
    if (error)
      return end(Error{
          error == http::error::end_of_stream ? ErrorCode::kUnavailable : ErrorCode::kUnsupported,
          where_ + " gave no answer that can be used: " + error.message() + "."});
    auto answer = answer_.release();
    end(FetchedAnswer{static_cast<int>(answer.result_int()), std::move(answer.body())});
  }

  /// The first result counts. Everything that is pending ends with it.
  void end(Result<FetchedAnswer> result) {
    if (result_) return;
    result_.emplace(std::move(result));
    io_.stop();
  }

  asio::io_context io_;
  const HubUrl& url_;
  const std::string where_;
  asio::steady_timer deadline_;
  std::shared_ptr<ConnectAttempt> opening_;
  std::optional<Stream> stream_;
  http::request<http::empty_body> request_;
  beast::flat_buffer buffer_;
  http::response_parser<http::string_body> answer_;
  std::optional<Result<FetchedAnswer>> result_;
};

}  // namespace

Result<FetchedAnswer> fetch(const HubUrl& url, const std::string& target,
                            const FetchOptions& options) {
  return Fetching(url, target, options).run(options.stop);
}

}  // namespace roomcast::net
