// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/http_server.h"

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/net/loopback_fixture.h"
#include "roomcast/net/tls/tls_fixture.h"
#include "roomcast/net/websocket_client.h"

namespace roomcast::net {
namespace {

using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class HttpServerTest : public LoopbackTest {
 protected:
  /// Answers /page, /large and /squeezed, and takes every WebSocket unless told otherwise.
  HttpServerOptions options() {
    HttpServerOptions options;
    options.port = 0;
    options.on_get = [this](std::string_view path) { return answer(path); };
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

  void listen(HttpServerOptions options) {
    auto server = HttpServer::listen(io_, std::move(options));
    ASSERT_TRUE(server.ok()) << server.error().message;
    server_ = *std::move(server);
  }
  void listen() { listen(options()); }

  /// Everything that the server answers to these bytes before it closes.
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

TEST_F(HttpServerTest, answers_get_with_the_body_and_security_headers) {
  listen();
  EXPECT_THAT(exchange(request("GET", "/page?version=1")),
              AllOf(StartsWith("HTTP/1.1 200 OK\r\n"), HasSubstr("Content-Length: 6\r\n"),
                    HasSubstr("X-Content-Type-Options: nosniff\r\n"),
                    HasSubstr("Content-Security-Policy: default-src 'none';"),
                    HasSubstr("Cross-Origin-Opener-Policy: same-origin\r\n"),
                    HasSubstr("Cross-Origin-Embedder-Policy: require-corp\r\n"),
                    HasSubstr("ETag: \"v1\"\r\n"), EndsWith("\r\n\r\na page")));
}

TEST_F(HttpServerTest, answers_head_without_the_body) {
  listen();
  EXPECT_THAT(exchange(request("HEAD", "/page")),
              AllOf(StartsWith("HTTP/1.1 200 OK\r\n"), HasSubstr("Content-Length: 6\r\n"),
                    EndsWith("\r\n\r\n")));
}

TEST_F(HttpServerTest, answers_404_405_and_400) {
  listen();
  EXPECT_THAT(exchange(request("GET", "/nothing")), StartsWith("HTTP/1.1 404 "));
  EXPECT_THAT(exchange(request("POST", "/page", "Content-Length: 3\r\n") + "abc"),
              AllOf(StartsWith("HTTP/1.1 405 "), HasSubstr("Allow: GET, HEAD\r\n")));
  EXPECT_THAT(exchange(request("GET", "/page", "Content-Length: 3\r\n") + "abc"),
              StartsWith("HTTP/1.1 400 "));
  EXPECT_EQ(times_asked_, 1);
}

TEST_F(HttpServerTest, gives_the_compressed_page_to_who_takes_it) {
  listen();
  const std::string takes = "Accept-Encoding: gzip, br\r\nConnection: close\r\n";
  EXPECT_THAT(exchange(request("GET", "/squeezed", takes)),
              AllOf(HasSubstr("Content-Encoding: gzip\r\n"), HasSubstr("Vary: Accept-Encoding\r\n"),
                    HasSubstr("ETag: \"v2-gzip\"\r\n"), EndsWith("\r\n\r\nsmall")));
  EXPECT_THAT(exchange(request("GET", "/squeezed", "If-None-Match: \"v2-gzip\"\r\n" + takes)),
              StartsWith("HTTP/1.1 304 "));
  EXPECT_THAT(exchange(request("GET", "/squeezed")),
              AllOf(Not(HasSubstr("Content-Encoding")), HasSubstr("Vary: Accept-Encoding\r\n"),
                    EndsWith("\r\n\r\na long page")));
}

TEST_F(HttpServerTest, answers_304_to_who_has_it) {
  listen();
  const auto known =
      exchange(request("GET", "/page", "If-None-Match: \"v0\", \"v1\"\r\nConnection: close\r\n"));
  EXPECT_THAT(known, AllOf(StartsWith("HTTP/1.1 304 "), EndsWith("\r\n\r\n")));
  EXPECT_THAT(exchange(request("GET", "/page", "If-None-Match: \"v2\"\r\nConnection: close\r\n")),
              StartsWith("HTTP/1.1 200 "));
}

TEST_F(HttpServerTest, answers_several_requests_on_one_connection) {
  listen();
  const std::string two = request("GET", "/page", "") + request("GET", "/nothing");
  EXPECT_THAT(exchange(two), AllOf(HasSubstr("a pageHTTP/1.1 404 ")));
}

TEST_F(HttpServerTest, sends_a_large_body_whole) {
  listen();
  const std::string received = exchange(request("GET", "/large"));
  EXPECT_EQ(received.size() - received.find("\r\n\r\n") - 4, 3'000'000U);
}

TEST_F(HttpServerTest, refuses_garbage_in_one_sentence) {
  listen();
  EXPECT_THAT(exchange("\x16\x03\x01garbage\r\n\r\n"),
              AllOf(StartsWith("HTTP/1.1 400 "), HasSubstr("not an HTTP request")));
}

TEST_F(HttpServerTest, refuses_an_oversized_header_even_while_it_still_comes) {
  listen();
  EXPECT_THAT(exchange("GET / HTTP/1.1\r\nX: " + std::string(200'000, 'x')),
              StartsWith("HTTP/1.1 431 "));
}

TEST_F(HttpServerTest, takes_a_header_just_below_the_limit) {
  listen();
  const std::string small = request("GET", "/page");
  const std::size_t room = 8 * 1024 - small.size() - std::string_view("X: \r\n").size();
  const auto with_header_of = [&](std::size_t size) {
    return request("GET", "/page", "X: " + std::string(size, 'x') + "\r\nConnection: close\r\n");
  };
  EXPECT_THAT(exchange(with_header_of(room)), StartsWith("HTTP/1.1 200 "));
  EXPECT_THAT(exchange(with_header_of(room + 64)), StartsWith("HTTP/1.1 431 "));
}

TEST_F(HttpServerTest, a_slow_header_is_cut_off) {
  auto slow = options();
  slow.header_within = 50ms;
  listen(std::move(slow));
  EXPECT_EQ(exchange("GET / HT"), "");
  EXPECT_TRUE(run_until([&] { return server_->connection_count() == 0; }));
}

/// Sends `bytes` every `period` until the server closes; how long that took.
std::chrono::nanoseconds time_until_closed(boost::asio::io_context& io,
                                           boost::asio::ip::tcp::socket& socket,
                                           std::string_view bytes,
                                           std::chrono::milliseconds period) {
  socket.non_blocking(true);
  const auto begin = std::chrono::steady_clock::now();
  auto next = begin;
  boost::system::error_code error;
  const auto goes_on = [&] { return !error || error == boost::asio::error::would_block; };
  while (goes_on() && std::chrono::steady_clock::now() < begin + 10s) {
    if (std::chrono::steady_clock::now() >= next) {
      socket.write_some(boost::asio::buffer(bytes), error);
      next += period;
    }
    io.restart();
    io.run_one_for(1ms);
  }
  return std::chrono::steady_clock::now() - begin;
}

TEST_F(HttpServerTest, a_header_that_drips_gains_no_time) {
  auto slow = options();
  slow.header_within = 100ms;
  listen(std::move(slow));
  auto socket = raw_connection(server_->port());
  send(socket, "GET / HTTP/1.1\r\nX: ");
  EXPECT_LT(time_until_closed(io_, socket, "x", 5ms), 5s);
}

TEST_F(HttpServerTest, a_flood_after_the_answer_gains_no_time) {
  auto quick = options();
  quick.goodbye_within = 50ms;
  listen(std::move(quick));
  auto socket = raw_connection(server_->port());
  EXPECT_LT(time_until_closed(io_, socket, std::string(10'000, 'x'), 0ms), 5s);
}

TEST_F(HttpServerTest, upgrades_a_good_request) {
  listen();
  auto socket = raw_connection(server_->port());
  send(socket, upgrade_request("Origin: http://" + host() + "\r\n"));
  const auto head =
      receive(socket, [](const std::string& all) { return all.ends_with("\r\n\r\n"); });
  EXPECT_THAT(head, AllOf(StartsWith("HTTP/1.1 101 "),
                          HasSubstr("Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n"),
                          HasSubstr("Sec-WebSocket-Protocol: roomcast.v1\r\n"),
                          Not(HasSubstr("Sec-WebSocket-Extensions"))));
  EXPECT_EQ(handlers_.size(), 1U);
  EXPECT_EQ(server_->connection_count(), 1U);
}

TEST_F(HttpServerTest, a_message_right_behind_the_upgrade_is_not_lost) {
  listen();
  auto socket = raw_connection(server_->port());
  std::string bytes = upgrade_request();
  bytes += std::string("\x82\x85\x37\xfa\x21\x3d\x7f\x9f\x4d\x51\x58", 11);
  send(socket, bytes);
  ASSERT_TRUE(run_until([&] { return !handlers_.empty() && !handlers_[0]->messages.empty(); }));
  EXPECT_EQ(std::string(handlers_[0]->messages[0].begin(), handlers_[0]->messages[0].end()),
            "Hello");
}

TEST_F(HttpServerTest, refuses_websockets_that_are_not_ours) {
  listen();
  EXPECT_THAT(exchange(upgrade_request("Origin: http://evil.example\r\n")),
              StartsWith("HTTP/1.1 403 "));
  EXPECT_THAT(exchange(upgrade_request("", "chat")),
              AllOf(StartsWith("HTTP/1.1 400 "), HasSubstr("roomcast.v1")));
  EXPECT_THAT(exchange(request("GET", "/ws")),
              AllOf(StartsWith("HTTP/1.1 426 "), HasSubstr("Upgrade: websocket\r\n")));
  EXPECT_TRUE(handlers_.empty());
}

TEST_F(HttpServerTest, a_websocket_that_nobody_wants_is_closed_with_1013) {
  auto full = options();
  full.on_websocket = [](auto, auto) { return nullptr; };
  listen(std::move(full));
  auto socket = raw_connection(server_->port());
  send(socket, upgrade_request());
  EXPECT_THAT(receive(socket, [](const auto& all) { return all.find("taken.") != all.npos; }),
              HasSubstr("\x03\xF5"
                        "No more connections are taken."));
}

TEST_F(HttpServerTest, turns_away_more_connections_than_allowed) {
  auto few = options();
  few.max_connections = 2;
  listen(std::move(few));
  const auto first = raw_connection(server_->port());
  auto second = raw_connection(server_->port());
  auto third = raw_connection(server_->port());
  EXPECT_THAT(receive(third), AllOf(StartsWith("HTTP/1.1 503 "), EndsWith("try again later.\r\n")));
  second.close();
  ASSERT_TRUE(run_until([&] { return server_->connection_count() == 1; }));
  EXPECT_THAT(exchange(request("GET", "/page")), StartsWith("HTTP/1.1 200 "));
}

TEST_F(HttpServerTest, an_open_websocket_counts_until_it_is_closed) {
  listen();
  auto socket = raw_connection(server_->port());
  send(socket, upgrade_request());
  ASSERT_TRUE(run_until([&] { return handlers_.size() == 1; }));
  EXPECT_EQ(server_->connection_count(), 1U);
  socket.close();
  ASSERT_TRUE(run_until([&] { return handlers_[0]->closed.has_value(); }));
  EXPECT_EQ(server_->connection_count(), 0U);
}

TEST_F(HttpServerTest, says_when_its_port_is_taken) {
  listen();
  auto same = options();
  same.port = server_->port();
  const auto second = HttpServer::listen(io_, same);
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.error().code, ErrorCode::kUnavailable);
  EXPECT_THAT(second.error().message,
              AllOf(HasSubstr(std::to_string(same.port)), HasSubstr("127.0.0.1"),
                    HasSubstr("choose another port")));
}

TEST_F(HttpServerTest, says_when_its_address_makes_no_sense) {
  auto wrong = options();
  wrong.address = "everywhere";
  const auto named = HttpServer::listen(io_, wrong);
  ASSERT_FALSE(named.ok());
  EXPECT_EQ(named.error().code, ErrorCode::kInvalidArgument);
  wrong.address = "203.0.113.1";  // documentation address: not ours
  const auto foreign = HttpServer::listen(io_, wrong);
  ASSERT_FALSE(foreign.ok());
  EXPECT_EQ(foreign.error().code, ErrorCode::kUnavailable);
}

TEST_F(HttpServerTest, stop_closes_websockets_with_1001_and_frees_the_port) {
  listen();
  auto client = std::make_shared<RecordingHandler>();
  connect(io_, {"127.0.0.1", server_->port(), "/ws"}, {}, [&](auto connection) {
    ASSERT_TRUE(connection.ok()) << connection.error().message;
    (*connection)->start(client);
  });
  ASSERT_TRUE(run_until([&] { return handlers_.size() == 1; }));
  const auto idle = raw_connection(server_->port());
  ASSERT_TRUE(run_until([&] { return server_->connection_count() == 2; }));
  const auto port = server_->port();
  server_->stop();
  ASSERT_TRUE(run_until([&] { return client->closed && handlers_[0]->closed; }));
  EXPECT_EQ(client->closed->code, close_code::kGoingAway);
  EXPECT_FALSE(handlers_[0]->closed->by_peer);
  io_.run_for(5s);
  EXPECT_TRUE(io_.stopped()) << "nothing is left to do";
  EXPECT_EQ(server_->connection_count(), 0U);
  auto again = options();
  again.port = port;
  io_.restart();
  EXPECT_TRUE(HttpServer::listen(io_, again).ok());
}

TEST_F(HttpServerTest, destroying_it_while_requests_are_under_way_is_fine) {
  listen();
  auto socket = raw_connection(server_->port());
  send(socket, request("GET", "/page"));
  auto other = raw_connection(server_->port());
  send(other, upgrade_request());
  server_.reset();
  io_.run_for(5s);
  EXPECT_TRUE(io_.stopped());
  EXPECT_EQ(times_asked_, 0);
  EXPECT_TRUE(handlers_.empty());
}

class EncryptedServerTest : public HttpServerTest {
 protected:
  EncryptedServerTest() {
    auto encrypted = options();
    encrypted.tls = server_context(certificate_);
    encrypted.header_within = 200ms;
    listen(std::move(encrypted));
  }

  Certificate certificate_ = self_signed();
};

TEST_F(EncryptedServerTest, tells_who_forgets_the_s) {
  EXPECT_THAT(exchange(request("GET", "/page")),
              AllOf(StartsWith("HTTP/1.1 400 "), HasSubstr("https://")));
  EXPECT_EQ(times_asked_, 0);
}

TEST_F(EncryptedServerTest, drops_who_never_shakes_hands) {
  auto silent = raw_connection(server_->port());
  auto noise = raw_connection(server_->port());
  send(noise, std::string(500, '\x5a'));
  receive(noise);
  receive(silent);
  EXPECT_TRUE(run_until([&] { return server_->connection_count() == 0; }));
}

TEST_F(HttpServerTest, what_programs_ask_may_have_a_body_and_is_answered_later) {
  auto with_program = options();
  std::optional<HttpRequest> asked;
  Respond respond;
  with_program.on_request = [&](HttpRequest request, Respond answer) {
    asked = std::move(request);
    respond = std::move(answer);
  };
  listen(std::move(with_program));
  auto socket = raw_connection(server_->port());
  send(socket,
       "POST /api/v1/rooms?x=1 HTTP/1.1\r\nHost: x\r\nConnection: close\r\n"
       "Authorization: Bearer abc\r\nContent-Length: 5\r\n\r\nhello");
  ASSERT_TRUE(run_until([&] { return asked.has_value(); }));
  EXPECT_EQ(asked->method, "POST");
  EXPECT_EQ(asked->path, "/api/v1/rooms");
  EXPECT_EQ(asked->authorization, "Bearer abc");
  EXPECT_EQ(asked->body, "hello");
  EXPECT_EQ(asked->peer, "127.0.0.1");
  respond(text_response(201, "made"));
  EXPECT_THAT(receive(socket), AllOf(StartsWith("HTTP/1.1 201 "), EndsWith("made")));
}

TEST_F(HttpServerTest, a_body_beyond_the_limit_is_refused) {
  auto with_program = options();
  with_program.on_request = [](const HttpRequest&, const Respond&) { FAIL(); };
  with_program.max_body_bytes = 10;
  listen(std::move(with_program));
  EXPECT_THAT(exchange(request("POST", "/api/x", "Content-Length: 11\r\n") + "hello world"),
              StartsWith("HTTP/1.1 413 "));
  EXPECT_THAT(exchange(request("POST", "/api/x", "Transfer-Encoding: chunked\r\n") +
                       "b\r\nhello world\r\n0\r\n\r\n"),
              StartsWith("HTTP/1.1 413 "));
}

TEST_F(HttpServerTest, an_answer_without_content_has_none) {
  auto with_program = options();
  with_program.on_request = [](const HttpRequest&, const Respond& respond) {
    respond(text_response(204, ""));
  };
  listen(std::move(with_program));
  const std::string answer = exchange(request("DELETE", "/api/x"));
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 204 "));
  EXPECT_THAT(answer, Not(HasSubstr("Content-Length")));
}

TEST_F(HttpServerTest, a_name_that_is_not_its_own_is_not_answered) {
  auto strict = options();
  strict.names = {.any_host = false, .hosts = {"hub.example"}, .origins = {}};
  listen(std::move(strict));
  EXPECT_THAT(exchange(request("GET", "/page")), StartsWith("HTTP/1.1 421 "));
  EXPECT_THAT(exchange("GET /page HTTP/1.1\r\nHost: hub.example\r\nConnection: close\r\n\r\n"),
              StartsWith("HTTP/1.1 200 "));
  EXPECT_THAT(exchange("GET /page HTTP/1.1\r\nHost: " + host() + "\r\nConnection: close\r\n\r\n"),
              StartsWith("HTTP/1.1 200 "));
}

TEST_F(HttpServerTest, whoever_may_not_connect_is_dropped_without_a_word) {
  auto closed = options();
  closed.may_connect = [](const std::string& peer) { return peer != "127.0.0.1"; };
  listen(std::move(closed));
  EXPECT_EQ(exchange(request("GET", "/page")), "");
}

TEST_F(HttpServerTest, a_renewed_certificate_is_shown_to_who_comes_after) {
  const auto before = self_signed(), after = self_signed();
  auto encrypted = options();
  encrypted.tls = server_context(before);
  listen(std::move(encrypted));
  server_->set_tls(server_context(after));
  std::optional<Result<std::shared_ptr<WebSocketConnection>>> connected;
  connect(
      io_,
      {.host = "127.0.0.1", .port = server_->port(), .tls = true, .pinned = after.fingerprint()},
      {}, [&](auto connection) { connected = std::move(connection); });
  ASSERT_TRUE(run_until([&] { return connected.has_value(); }));
  EXPECT_TRUE(connected->ok()) << connected->error().message;
}

}  // namespace
}  // namespace roomcast::net
