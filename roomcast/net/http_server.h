// SPDX-License-Identifier: Apache-2.0
// HttpServer: one listening port for the page, plain HTTP answers, the API and the WebSocket. Pages
// answer GET and HEAD; API requests (`on_request`) may have a body. A WebSocket is accepted if
// path, version, subprotocol and Origin are correct (docs/spec/wire.md section 1).
// Threading: connections are accepted, and plain HTTP is answered, on the one thread that runs the
// io_context `door`. Each WebSocket is handed over to one of the workers, where it stays and where
// its callbacks are called, so that floods and slow clients do not delay the workers. `door` and
// the workers may be the same thread. Source: RFC 9110 (HTTP), RFC 6455 section 4.2 (server
// handshake); parsing by Boost.Beast.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <boost/asio/io_context.hpp>

#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/net/allowed_names.h"
#include "roomcast/net/http_request.h"
#include "roomcast/net/http_response.h"
#include "roomcast/net/tls/tls_context.h"
#include "roomcast/net/websocket_connection.h"

namespace roomcast::net {

struct HttpServerOptions {
  std::string address = "127.0.0.1";  // a numeric IPv4 or IPv6 address; "0.0.0.0" for all
  std::uint16_t port = 7600;          // 0 = any free one, see HttpServer::port()

  /// If set, all connections are encrypted; an unencrypted request gets an error answer.
  std::shared_ptr<const TlsServerContext> tls = {};

  /// The answer to GET `path` ("/healthz") with `query` ("room=lab&mode=mesh", percent-encoded,
  /// often empty); nothing means 404. HEAD is derived from it. Called on the door's thread.
  std::function<std::optional<HttpResponse>(std::string_view path, std::string_view query)> on_get =
      {};

  /// Called on the door's thread for paths that begin with one of `request_paths`; a null
  /// `on_request` means 404.
  std::function<void(HttpRequest, Respond)> on_request = {};
  std::vector<std::string> request_paths = {"/api/"};
  std::size_t max_body_bytes = 64 * 1024;

  /// Called on a worker with a newly opened WebSocket, which is then started with the returned
  /// handler. Null refuses it (closed with 1013).
  std::function<std::shared_ptr<ConnectionHandler>(std::shared_ptr<WebSocketConnection>,
                                                   std::size_t thread)>
      on_websocket = {};
  std::string websocket_path = "/ws";
  std::string subprotocol = "roomcast.v1";

  AllowedNames names = {};
  /// Whether pages of this site ("https://b.example.org:7600") may connect as well. Called on the
  /// door's thread.
  std::function<bool(std::string_view origin)> allows_origin = {};

  /// Called on the door's thread with peer_name(), for each connection and each request. False
  /// drops the connection without an answer.
  std::function<bool(const std::string& peer)> may_connect = {};
  /// Unsettled connections per peer (WebSocketConnection::settle); more are dropped.
  std::size_t max_unsettled_per_peer = 64;
  std::vector<std::string> uncounted_peers = {};  // exempt peers, e.g. a proxy

  std::size_t max_message_bytes = 16 * 1024;  // of a new WebSocket; its handler may change it
  std::size_t max_connections = 1024;         // open sockets of all kinds; more are rejected (503)
  std::size_t max_header_bytes = 8 * 1024;    // of a request
  std::chrono::milliseconds header_within{5'000};     // a whole request header, and idle keep-alive
  std::chrono::milliseconds idle_grace{1'000};        // for a next request that is on its way then
  std::chrono::milliseconds response_within{60'000};  // a whole answer
  std::chrono::milliseconds malformed_reply_delay{3'000};  // before a malformed request is answered
  std::chrono::milliseconds linger_timeout{1'000};  // from our last byte to the closed socket
  ConnectionTimings websocket_timings = {};
};

class ServerState;

class HttpServer {
 public:
  /// Listens at once; serves while the threads run. Errors: kInvalidArgument (not an address),
  /// kUnavailable (port in use, or not permitted).
  static Result<std::unique_ptr<HttpServer>> listen(
      boost::asio::io_context& door, std::span<boost::asio::io_context* const> workers,
      HttpServerOptions options, LogSink log = {});
  static Result<std::unique_ptr<HttpServer>> listen(boost::asio::io_context& io,
                                                    HttpServerOptions options, LogSink log = {});
  /// As stop().
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  [[nodiscard]] std::uint16_t port() const;
  /// Sockets of all kinds that are open now.
  [[nodiscard]] std::size_t connection_count() const;

  /// For new connections. Call on the door's thread, and only if TLS was set from the start.
  void set_tls(std::shared_ptr<const TlsServerContext> tls);

  /// Stops listening and closes all connections, WebSockets with 1001. They end while the threads
  /// continue to run. Call on the door's thread, or after it has ended.
  void stop();

 private:
  explicit HttpServer(std::shared_ptr<ServerState> state);
  std::shared_ptr<ServerState> state_;  // shared with the operations still open
};

}  // namespace roomcast::net
