// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/http_session.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <boost/asio/buffer.hpp>
#include <boost/asio/dispatch.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>

#include "roomcast/net/page_policy.h"
#include "roomcast/net/request_framing.h"

namespace roomcast::net {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;

namespace {

// The page connects to this hub only, unless the answer extends that (page_policy); it runs its own
// scripts only, and cannot be shown in a frame, unless the answer names a site that may do that.
// Cross-origin isolation gives it exact clocks and memory shared with its workers.
constexpr std::pair<std::string_view, std::string_view> kSecurityFields[] = {
    {"Content-Security-Policy", kPagePolicy},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Cross-Origin-Embedder-Policy", "require-corp"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Referrer-Policy", "no-referrer"},
    {"Permissions-Policy",
     "camera=(), microphone=(self), geolocation=(), xr-spatial-tracking=(self)"},
    {"X-Content-Type-Options", "nosniff"},
};

beast::string_view text(std::string_view view) {
  return {view.data(), view.size()};
}

std::string_view path_of(beast::string_view target) {
  const std::string_view whole(target.data(), target.size());
  return whole.substr(0, whole.find('?'));
}

std::string_view query_of(beast::string_view target) {
  const std::string_view whole(target.data(), target.size());
  const auto mark = whole.find('?');
  return mark == std::string_view::npos ? std::string_view() : whole.substr(mark + 1);
}

constexpr std::uint64_t kPieceBytes = 256 << 10;  // of a long body, in memory at a time

constexpr std::string_view kSpeaksTls =
    "HTTP/1.1 400 Bad Request\r\n"
    "Content-Type: text/plain; charset=utf-8\r\n"
    "Content-Length: 67\r\n"
    "Server: roomcast\r\n"
    "Connection: close\r\n"
    "\r\n"
    "This hub is encrypted: its address begins with https:// or wss://.\n";

bool has_it_already(const RequestHeader& request, std::string_view etag) {
  if (etag.empty()) return false;
  const auto known = request[http::field::if_none_match];
  return known == "*" ||
         std::string_view(known.data(), known.size()).find(etag) != std::string_view::npos;
}

bool takes_gzip(const RequestHeader& request) {
  const auto accepted = request[http::field::accept_encoding];
  return std::string_view(accepted.data(), accepted.size()).find("gzip") != std::string_view::npos;
}

/// Uses the compressed body, under its own ETag, if the client accepts it.
void choose_encoding(const RequestHeader& request, HttpResponse& response) {
  if (response.gzip == nullptr) return;
  response.headers.emplace_back("Vary", "Accept-Encoding");
  if (!takes_gzip(request)) return;
  response.body = std::exchange(response.gzip, nullptr);
  response.headers.emplace_back("Content-Encoding", "gzip");
  if (!response.etag.empty()) response.etag.insert(response.etag.size() - 1, "-gzip");
}

void set_fields(EmptyResponse& message, const HttpResponse& response, bool keep_alive) {
  message.keep_alive(keep_alive);
  message.set(http::field::server, "roomcast");
  message.set(http::field::cache_control, response.cache_control);
  for (const auto& [name, value] : kSecurityFields) message.set(text(name), text(value));
  if (!response.etag.empty()) message.set(http::field::etag, response.etag);
  for (const auto& [name, value] : response.headers) message.set(name, value);
}

std::uint64_t size_of(const HttpResponse& response) {
  if (response.long_body != nullptr) return response.long_body->size();
  return response.body == nullptr ? 0 : response.body->size();
}

/// Tells the client for how long its connection is kept, so that it sends nothing more after that.
void promise_to_keep(EmptyResponse& message, std::chrono::milliseconds idle) {
  const auto whole = std::chrono::floor<std::chrono::seconds>(idle).count();
  if (whole == 0) return;
  message.set(http::field::connection, "keep-alive");
  message.set(http::field::keep_alive, "timeout=" + std::to_string(whole));
}

EmptyResponse header_of(const HttpResponse& response, bool keep_alive) {
  EmptyResponse message(static_cast<http::status>(response.status), 11);
  set_fields(message, response, keep_alive);
  if (response.status == 304 || response.status == 204) return message;
  message.set(http::field::content_type, response.content_type);
  message.content_length(size_of(response));
  return message;
}

}  // namespace

HttpSession::HttpSession(Stream stream, std::shared_ptr<const HttpServerOptions> options,
                         Origins origins)
    : stream_(std::move(stream)),
      deadline_(stream_.get_executor()),
      options_(std::move(options)),
      origins_(std::move(origins)),
      buffer_(options_->max_header_bytes + 1) {}

void HttpSession::start() {
  origins_.lease->end_with([weak = weak_from_this()] {
    if (const auto self = weak.lock()) self->abort();
  });
  read_request(options_->header_within);
}

void HttpSession::read_request(std::chrono::milliseconds within) {
  body_parser_.reset();
  parser_.emplace();
  parser_->header_limit(static_cast<std::uint32_t>(options_->max_header_bytes));
  abort_after(within);
  http::async_read_header(
      stream_, buffer_, *parser_,
      [self = shared_from_this()](ErrorCode error, std::size_t) { self->on_header(error); });
}

void HttpSession::on_header(ErrorCode error) {
  if (!stream_.is_open()) return;  // closed while this was pending
  if (error) return answer_fault(error);
  if (options_->may_connect && !options_->may_connect(origins_.peer)) return abort();
  answer_request();
}

/// A request that cannot be parsed gets an answer; a connection that is lost or too slow gets none.
void HttpSession::answer_fault(ErrorCode error) {
  if (stream_.peer_speaks_plain_http()) {
    stream_.write_in_the_clear(kSpeaksTls);
    return abort();
  }
  if (error == http::error::header_limit || error == http::error::buffer_overflow) {
    return send(text_response(431, "The request header is larger than the limit of " +
                                       std::to_string(options_->max_header_bytes) + " bytes.\n"),
                false);
  }
  const bool is_http_fault =
      error.category() == http::make_error_code(http::error::bad_method).category();
  const bool is_cut = error == http::error::end_of_stream || error == http::error::partial_message;
  if (!stream_.tls_fault().empty() || (is_http_fault && !is_cut))
    return answer_malformed_later(error);
  abort();
}

/// Delays the answer: a client that opens and closes connections as fast as it can costs the
/// machine more than one that is kept waiting.
void HttpSession::answer_malformed_later(ErrorCode error) {
  deadline_.expires_after(options_->malformed_reply_delay);
  deadline_.async_wait([self = shared_from_this(), error](ErrorCode cancelled) {
    if (cancelled || !self->stream_.is_open()) return;
    if (!self->stream_.tls_fault().empty()) return self->abort();
    self->send(text_response(400, "This is not an HTTP request: " + error.message() + ".\n"),
               false);
  });
}

void HttpSession::answer_request() {
  const auto& request = parser_->get();
  if (auto refusal = refuse_ambiguous(request)) return send(*std::move(refusal), false);
  const auto host = request[http::field::host];
  if (!options_->names.allows_host({host.data(), host.size()})) {
    return send(
        text_response(421, "This server does not have the requested name; use its own address.\n"),
        false);
  }
  if (is_api_path(path_of(request.target()))) return read_body();
  if (request.method() != http::verb::get && request.method() != http::verb::head) {
    HttpResponse response = text_response(405, "Only GET and HEAD are allowed here.\n");
    response.headers = {{"Allow", "GET, HEAD"}};
    return send(std::move(response), false);
  }
  if (parser_->chunked() || parser_->content_length().value_or(0) != 0) {
    return send(text_response(400, "A request must not have a body here.\n"), false);
  }
  const std::string_view path = path_of(request.target());
  if (path == options_->websocket_path) return upgrade();
  send(response_for(path, query_of(request.target())), wants_more());
}

bool HttpSession::is_api_path(std::string_view path) const {
  return options_->on_request && std::ranges::any_of(options_->request_paths, [&](const auto& own) {
           return path.starts_with(own);
         });
}

/// The parser compares a body's announced length with the limit that it had when it read the
/// header; it counts the bytes of chunked bodies.
void HttpSession::read_body() {
  if (parser_->content_length().value_or(0) > options_->max_body_bytes) return refuse_body();
  body_parser_.emplace(std::move(*parser_));
  body_parser_->body_limit(options_->max_body_bytes);
  http::async_read(stream_, buffer_, *body_parser_,
                   [self = shared_from_this()](ErrorCode error, std::size_t) {
                     if (!self->stream_.is_open()) return;
                     if (!error) return self->call_api();
                     if (error != http::error::body_limit) return self->abort();
                     self->refuse_body();
                   });
}

void HttpSession::refuse_body() {
  send(text_response(413, "A request's body must have at most " +
                              std::to_string(options_->max_body_bytes) + " bytes here.\n"),
       false);
}

/// The answer may come from another thread.
void HttpSession::call_api() {
  abort_after(options_->response_within);
  auto& message = body_parser_->get();
  const auto authorization = message[http::field::authorization];
  HttpRequest request{
      .method = message.method() == http::verb::head ? "GET" : std::string(message.method_string()),
      .path = std::string(path_of(message.target())),
      .authorization = {authorization.data(), authorization.size()},
      .body = std::move(message.body()),
      .peer = origins_.peer};
  auto waiting = std::make_shared<std::shared_ptr<HttpSession>>(shared_from_this());
  options_->on_request(std::move(request), [waiting](HttpResponse response) {
    auto self = std::exchange(*waiting, nullptr);  // released on its own thread only
    if (self == nullptr) return;                   // already answered
    const auto executor = self->stream_.get_executor();
    asio::dispatch(executor, [self = std::move(self), response = std::move(response)]() mutable {
      if (self->stream_.is_open()) self->send(std::move(response), self->wants_more());
    });
  });
}

const RequestHeader& HttpSession::header() const {
  if (body_parser_) return body_parser_->get();
  return parser_->get();
}

bool HttpSession::wants_more() const {
  return body_parser_ ? body_parser_->keep_alive() : parser_->keep_alive();
}

HttpResponse HttpSession::response_for(std::string_view path, std::string_view query) const {
  if (options_->on_get) {
    if (auto response = options_->on_get(path, query)) return *std::move(response);
  }
  return text_response(404, "This address does not exist.\n");
}

void HttpSession::send(HttpResponse response, bool keep_alive) {
  const auto& request = header();
  choose_encoding(request, response);
  if (response.status == 200 && has_it_already(request, response.etag)) response.status = 304;
  auto header = header_of(response, keep_alive);
  if (keep_alive) promise_to_keep(header, options_->header_within);
  if (response.status == 304 || response.status == 204 || request.method() == http::verb::head) {
    response.body = nullptr;
    response.long_body = nullptr;
  }
  if (response.long_body != nullptr) {
    return write(header, nullptr,
                 [self = shared_from_this(), body = std::move(response.long_body),
                  keep_alive](ErrorCode error) {
                   if (error) return self->abort();
                   self->write_piece(body, 0, keep_alive);
                 });
  }
  write(header, std::move(response.body), [self = shared_from_this(), keep_alive](ErrorCode error) {
    self->on_written(error, keep_alive);
  });
}

/// Header and body are written as they lie in memory: beast's own serializer would be compiled for
/// each kind of body, and takes longer than the rest of the library.
void HttpSession::write(const EmptyResponse& header, std::shared_ptr<const std::string> body,
                        std::function<void(ErrorCode)> on_written) {
  abort_after(options_->response_within);
  std::ostringstream text;
  text << header.base();
  auto head = std::make_shared<const std::string>(std::move(text).str());
  if (body == nullptr) body = std::make_shared<const std::string>();
  const std::array buffers{asio::buffer(*head), asio::buffer(*body)};
  asio::async_write(
      stream_, buffers,
      [head = std::move(head), body = std::move(body), on_written = std::move(on_written)](
          ErrorCode error, std::size_t) { on_written(error); });
}

/// The time limit of an answer applies to each piece.
void HttpSession::write_piece(std::shared_ptr<const LongBody> body, std::uint64_t offset,
                              bool keep_alive) {
  if (!stream_.is_open()) return;
  const std::uint64_t left = body->size() - offset;
  if (left == 0) return on_written({}, keep_alive);
  auto piece = std::make_shared<std::vector<std::uint8_t>>(std::min(left, kPieceBytes));
  if (!body->read(offset, *piece)) return abort();
  abort_after(options_->response_within);
  const auto buffer = asio::buffer(*piece);
  asio::async_write(stream_, buffer,
                    [self = shared_from_this(), body = std::move(body), piece = std::move(piece),
                     offset, keep_alive](ErrorCode error, std::size_t written) {
                      if (error) return self->abort();
                      self->write_piece(body, offset + written, keep_alive);
                    });
}

void HttpSession::on_written(ErrorCode error, bool keep_alive) {
  if (error || !stream_.is_open()) return abort();
  if (keep_alive) return read_request(options_->header_within + options_->idle_grace);
  stream_.shutdown_send();
  abort_after(options_->linger_timeout);
  say_goodbye();
}

/// Reads until the peer has closed its side as well, so that our last bytes are not lost to a TCP
/// reset.
void HttpSession::say_goodbye() {
  stream_.async_read_some(asio::buffer(discarded_),
                          [self = shared_from_this()](ErrorCode error, std::size_t) {
                            if (error) return self->abort();
                            self->say_goodbye();
                          });
}

void HttpSession::upgrade() {
  const auto& request = parser_->get();
  AllowedNames names = options_->names;
  const auto origin = request[http::field::origin];
  if (options_->allows_origin && options_->allows_origin({origin.data(), origin.size()})) {
    names.origins.emplace_back(origin);
  }
  if (auto refusal = refuse_upgrade(request, options_->subprotocol, names)) {
    return send(*std::move(refusal), false);
  }
  // Once accepted, the connection counts as a WebSocket: its worker closes it when the server
  // stops.
  origins_.lease->end_with({});
  write(make_upgrade(request, options_->subprotocol), nullptr,
        [self = shared_from_this()](ErrorCode error) {
          if (error || !self->stream_.is_open()) return self->abort();
          self->become_websocket();
        });
}

void HttpSession::become_websocket() {
  deadline_.cancel();
  const auto received = buffer_.cdata();
  const auto* const first = static_cast<const std::uint8_t*>(received.data());
  origins_.workers->take(std::move(stream_), {first, first + received.size()},
                         std::move(origins_.place));
  origins_.lease.reset();
}

void HttpSession::abort() {
  deadline_.cancel();
  stream_.close();
}

void HttpSession::abort_after(std::chrono::milliseconds time) {
  deadline_.expires_after(time);
  deadline_.async_wait([weak = weak_from_this()](ErrorCode cancelled) {
    const auto self = weak.lock();
    if (cancelled || self == nullptr) return;
    const bool put_off = self->deadline_.expiry() > std::chrono::steady_clock::now();
    if (!put_off) self->stream_.close();
  });
}

}  // namespace roomcast::net
