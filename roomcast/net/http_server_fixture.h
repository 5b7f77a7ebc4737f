// SPDX-License-Identifier: Apache-2.0
// For tests: an HttpServer on loopback that is sent raw bytes.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "roomcast/net/http_server.h"
#include "roomcast/net/loopback_fixture.h"

namespace roomcast::net {

/// Letters from a to z, again and again; those from `ends_at` on cannot be read.
class Alphabets final : public LongBody {
 public:
  Alphabets(std::uint64_t size, std::uint64_t ends_at) : size_(size), ends_at_(ends_at) {}
  [[nodiscard]] std::uint64_t size() const override { return size_; }
  [[nodiscard]] Status read(std::uint64_t offset, std::span<std::uint8_t> out) const override {
    if (offset + out.size() > ends_at_) return Error{ErrorCode::kMalformed, "it ends too early"};
    for (auto& letter : out) letter = static_cast<std::uint8_t>('a' + offset++ % 26);
    return {};
  }

 private:
  std::uint64_t size_, ends_at_;
};

class HttpServerTest : public LoopbackTest {
 protected:
  /// Answers /page, /large, /long, /shrunk and /squeezed, and accepts every WebSocket by default.
  HttpServerOptions options() {
    HttpServerOptions options;
    options.port = 0;
    options.names.hosts = {"x"};  // of request()
    options.on_get = [this](std::string_view path, std::string_view) { return answer(path); };
    options.on_websocket = [this](std::shared_ptr<WebSocketConnection> connection, std::size_t) {
      connections_.push_back(std::move(connection));
      handlers_.push_back(std::make_shared<RecordingHandler>());
      return handlers_.back();
    };
    return options;
  }

  std::optional<HttpResponse> answer(std::string_view path) {
    ++times_asked_;
    if (path == "/large") return text_response(200, std::string(3'000'000, 'x'));
    if (path == "/long" || path == "/shrunk") {
      HttpResponse file;
      file.long_body = std::make_shared<Alphabets>(kLong, path == "/long" ? kLong : kLong / 2);
      return file;
    }
    if (path == "/squeezed") {
      HttpResponse page = text_response(200, "a long page");
      page.gzip = std::make_shared<const std::string>("small");
      page.etag = "\"v2\"";
      return page;
    }
    if (path != "/page") return std::nullopt;
    HttpResponse page = text_response(200, "a page");
    page.etag = "\"v1\"";
    return page;
  }

  static constexpr std::uint64_t kLong = 1'000'000;

  void listen(HttpServerOptions options) {
    auto server = HttpServer::listen(io_, std::move(options));
    ASSERT_TRUE(server.ok()) << server.error().message;
    server_ = *std::move(server);
  }
  void listen() { listen(options()); }

  /// Sends these bytes and returns the server's whole answer, up to the close.
  std::string exchange(std::string_view bytes) {
    auto socket = raw_connection(server_->port());
    send(socket, bytes);
    return receive(socket);
  }

  [[nodiscard]] std::string upgrade_request(std::string_view more = "",
                                            std::string_view subprotocol = "roomcast.v1") const {
    return "GET /ws HTTP/1.1\r\nHost: " + host() +
           "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
           "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: " +
           std::string(subprotocol) + "\r\n" + std::string(more) + "\r\n";
  }
  [[nodiscard]] std::string host() const { return "127.0.0.1:" + std::to_string(server_->port()); }

  static std::string request(std::string_view method, std::string_view path,
                             std::string_view more = "Connection: close\r\n") {
    return std::string(method) + " " + std::string(path) + " HTTP/1.1\r\nHost: x\r\n" +
           std::string(more) + "\r\n";
  }

  int times_asked_ = 0;
  std::vector<std::shared_ptr<WebSocketConnection>> connections_;
  std::vector<std::shared_ptr<RecordingHandler>> handlers_;
  std::unique_ptr<HttpServer> server_;
};

}  // namespace roomcast::net
