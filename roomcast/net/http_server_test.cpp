// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/http_server.h"

#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <boost/asio/post.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/net/http_server_fixture.h"
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

TEST_F(HttpServerTest, sends_a_long_body_in_pieces_and_keeps_the_connection) {
  listen();
  const std::string answer = exchange(request("GET", "/long", "") + request("GET", "/page"));
  const auto begin = answer.find("\r\n\r\n") + 4;
  ASSERT_GT(answer.size(), begin + kLong);
  EXPECT_THAT(answer, HasSubstr("Content-Length: 1000000\r\n"));
  for (std::uint64_t i = 0; i < kLong; i += 999)
    EXPECT_EQ(answer[begin + i], static_cast<char>('a' + i % 26)) << i;
  EXPECT_THAT(answer.substr(begin + kLong),
              AllOf(StartsWith("HTTP/1.1 200 OK"), EndsWith("a page")));
  EXPECT_THAT(exchange(request("HEAD", "/long")),
              AllOf(HasSubstr("Content-Length: 1000000\r\n"), EndsWith("\r\n\r\n")));
}

TEST_F(HttpServerTest, breaks_off_a_long_body_that_has_become_shorter) {
  listen();
  const std::string answer = exchange(request("GET", "/shrunk", ""));
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200 OK"));
  EXPECT_LT(answer.size(), kLong);
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

TEST_F(HttpServerTest, sends_the_compressed_page_to_clients_that_accept_it) {
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

TEST_F(HttpServerTest, answers_304_for_an_unchanged_page) {
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

TEST_F(HttpServerTest, tells_for_how_long_a_connection_is_kept) {
  listen();
  auto socket = raw_connection(server_->port());
  send(socket, request("GET", "/page", ""));
  EXPECT_THAT(
      receive(socket, [](const auto& all) { return all.ends_with("a page"); }),
      AllOf(HasSubstr("Connection: keep-alive\r\n"), HasSubstr("Keep-Alive: timeout=5\r\n")));
  EXPECT_THAT(exchange(request("GET", "/page")),
              AllOf(HasSubstr("Connection: close\r\n"), Not(HasSubstr("Keep-Alive"))));
}

TEST_F(HttpServerTest, sends_a_large_body_whole) {
  listen();
  const std::string received = exchange(request("GET", "/large"));
  EXPECT_EQ(received.size() - received.find("\r\n\r\n") - 4, 3'000'000U);
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

TEST_F(HttpServerTest, the_accepting_thread_serves_pages_and_workers_serve_websockets) {
  boost::asio::io_context first, second;
  auto server = HttpServer::listen(io_, std::array{&first, &second}, options());
  ASSERT_TRUE(server.ok()) << server.error().message;
  server_ = *std::move(server);
  auto one = raw_connection(server_->port()), other = raw_connection(server_->port());
  for (auto* socket : {&one, &other}) {
    send(*socket, upgrade_request());
    receive(*socket, [](const std::string& all) { return all.ends_with("\r\n\r\n"); });
  }
  EXPECT_THAT(exchange(request("GET", "/page")), EndsWith("a page")) << "no worker has run";
  EXPECT_TRUE(run_until([&] { return server_->connection_count() == 2; }));
  EXPECT_TRUE(connections_.empty());
  EXPECT_GT(first.poll(), 0U);
  EXPECT_EQ(connections_.size(), 1U) << "each worker gets its share";
  EXPECT_GT(second.poll(), 0U);
  EXPECT_EQ(connections_.size(), 2U);
  connections_.clear();
  server_.reset();
}

TEST_F(HttpServerTest, a_websocket_that_a_worker_gets_after_the_end_is_closed) {
  boost::asio::io_context worker;
  auto server = HttpServer::listen(io_, std::array{&worker}, options());
  ASSERT_TRUE(server.ok()) << server.error().message;
  server_ = *std::move(server);
  boost::asio::post(worker, [&] { server_->stop(); });
  auto socket = raw_connection(server_->port());
  send(socket, upgrade_request());
  receive(socket, [](const std::string& all) { return all.ends_with("\r\n\r\n"); });
  ASSERT_TRUE(run_until([&] { return worker.poll() > 0 && !handlers_.empty(); }));
  EXPECT_THAT(receive(socket, [](const std::string& all) { return all.ends_with("stops."); }),
              HasSubstr("\x03\xe9The hub stops."));
  socket.close();
  ASSERT_GT(worker.run_one_for(10s), 0U);
  worker.poll();
  EXPECT_TRUE(handlers_[0]->closed.has_value());
  connections_.clear();
  server_.reset();
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

TEST_F(HttpServerTest, a_refused_websocket_is_closed_with_1013) {
  auto full = options();
  full.on_websocket = [](auto, auto) { return nullptr; };
  listen(std::move(full));
  auto socket = raw_connection(server_->port());
  send(socket, upgrade_request());
  EXPECT_THAT(
      receive(socket, [](const auto& all) { return all.find("more connections.") != all.npos; }),
      HasSubstr("\x03\xF5"
                "The hub accepts no more connections."));
}

TEST_F(HttpServerTest, reports_a_port_in_use) {
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

TEST_F(HttpServerTest, reports_an_invalid_address) {
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

TEST_F(HttpServerTest, requests_to_the_interface_may_have_a_body_and_are_answered_later) {
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

TEST_F(HttpServerTest, later_connections_get_a_renewed_certificate) {
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
