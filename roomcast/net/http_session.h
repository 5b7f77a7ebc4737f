// SPDX-License-Identifier: Apache-2.0
// HttpSession: one accepted socket, from its first byte until it is closed or upgraded to a
// WebSocket, which is handed over to a worker. Answers requests one after another (keep-alive);
// sizes and times are bounded. Threading: runs on its io_context's thread.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>

#include "roomcast/net/http_response.h"
#include "roomcast/net/http_server.h"
#include "roomcast/net/open_connections.h"
#include "roomcast/net/peer_counts.h"
#include "roomcast/net/stream.h"
#include "roomcast/net/websocket_handshake.h"
#include "roomcast/net/websocket_workers.h"

namespace roomcast::net {

class HttpSession : public std::enable_shared_from_this<HttpSession> {
 public:
  /// The peer, the workers for an upgrade, and the reservations of this connection.
  struct Origins {
    std::string peer;  // peer_name()
    std::shared_ptr<WebSocketWorkers> workers;
    std::shared_ptr<OpenConnections::Lease> lease = {};
    std::shared_ptr<PeerCounts::Place> place = {};
  };
  HttpSession(Stream stream, std::shared_ptr<const HttpServerOptions> options, Origins origins);

  void start();

 private:
  using Parser = boost::beast::http::request_parser<boost::beast::http::empty_body>;
  using BodyParser = boost::beast::http::request_parser<boost::beast::http::string_body>;
  using ErrorCode = boost::beast::error_code;

  void read_request(std::chrono::milliseconds within);
  void on_header(ErrorCode error);
  void answer_fault(ErrorCode error);
  void answer_malformed_later(ErrorCode error);
  void answer_request();
  [[nodiscard]] bool is_api_path(std::string_view path) const;
  void read_body();
  void refuse_body();
  void call_api();
  [[nodiscard]] HttpResponse response_for(std::string_view path, std::string_view query) const;

  void send(HttpResponse response, bool keep_alive);
  [[nodiscard]] const RequestHeader& header() const;
  [[nodiscard]] bool wants_more() const;
  void write(const EmptyResponse& header, std::shared_ptr<const std::string> body,
             std::function<void(ErrorCode)> on_written);
  void write_piece(std::shared_ptr<const LongBody> body, std::uint64_t offset, bool keep_alive);
  void on_written(ErrorCode error, bool keep_alive);
  void say_goodbye();

  void upgrade();
  void become_websocket();
  void abort();
  /// Aborts after `time` unless it is called again before.
  void abort_after(std::chrono::milliseconds time);

  Stream stream_;
  boost::asio::steady_timer deadline_;
  std::shared_ptr<const HttpServerOptions> options_;
  Origins origins_;
  boost::beast::flat_buffer buffer_;
  std::optional<Parser> parser_;
  std::optional<BodyParser> body_parser_;  // of an API request
  std::array<char, 1024> discarded_{};
};

}  // namespace roomcast::net
