// SPDX-License-Identifier: Apache-2.0
// Protection of an HttpServer against misuse: limits and timeouts.
#include <chrono>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/net/http_server_fixture.h"
#include "roomcast/net/tls/tls_fixture.h"

namespace roomcast::net {
namespace {

using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(HttpServerTest, refuses_garbage_in_one_sentence_after_a_while) {
  auto patient = options();
  patient.malformed_reply_delay = 50ms;
  listen(std::move(patient));
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THAT(exchange("\x16\x03\x01garbage\r\n\r\n"),
              AllOf(StartsWith("HTTP/1.1 400 "), HasSubstr("not an HTTP request")));
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 50ms);
}

TEST_F(HttpServerTest, connections_that_sent_garbage_do_not_outlive_the_server) {
  auto patient = options();
  patient.malformed_reply_delay = 1h;
  listen(std::move(patient));
  auto socket = raw_connection(server_->port());
  send(socket, "garbage\r\n\r\n");
  ASSERT_TRUE(run_until([&] { return server_->connection_count() == 1; }));
  EXPECT_THAT(exchange(request("GET", "/page")), StartsWith("HTTP/1.1 200 "));
  server_->stop();
  EXPECT_EQ(receive(socket), "");
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

TEST_F(HttpServerTest, an_idle_connection_is_cut_off) {
  auto quick = options();
  quick.header_within = 50ms;
  quick.idle_grace = 50ms;
  listen(std::move(quick));
  EXPECT_THAT(exchange(request("GET", "/page", "")), EndsWith("a page"));
}

TEST_F(HttpServerTest, a_request_that_is_on_its_way_when_the_promised_time_ends_is_answered) {
  auto patient = options();
  patient.header_within = 50ms;
  patient.idle_grace = 10s;
  listen(std::move(patient));
  auto socket = raw_connection(server_->port());
  const auto answered = [](const std::string& all) { return all.ends_with("a page"); };
  send(socket, request("GET", "/page", ""));
  EXPECT_THAT(receive(socket, answered), EndsWith("a page"));
  run_for(150ms);
  send(socket, request("GET", "/page", ""));
  EXPECT_THAT(receive(socket, answered), EndsWith("a page"));
}

/// Sends `bytes` every `period` until the server closes the connection; returns the time that this
/// took.
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
  quick.linger_timeout = 50ms;
  listen(std::move(quick));
  auto socket = raw_connection(server_->port());
  EXPECT_LT(time_until_closed(io_, socket, std::string(10'000, 'x'), 0ms), 5s);
}

TEST_F(HttpServerTest, refuses_connections_above_the_limit) {
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

TEST_F(EncryptedServerTest, answers_unencrypted_requests_with_the_encrypted_scheme) {
  EXPECT_THAT(exchange(request("GET", "/page")),
              AllOf(StartsWith("HTTP/1.1 400 "), HasSubstr("https://")));
  EXPECT_EQ(times_asked_, 0);
}

TEST_F(EncryptedServerTest, drops_connections_that_never_finish_the_handshake) {
  auto silent = raw_connection(server_->port());
  auto noise = raw_connection(server_->port());
  send(noise, std::string(500, '\x5a'));
  receive(noise);
  receive(silent);
  EXPECT_TRUE(run_until([&] { return server_->connection_count() == 0; }));
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

TEST_F(HttpServerTest, refused_peers_are_dropped_without_an_answer) {
  auto closed = options();
  closed.may_connect = [](const std::string& peer) { return peer != "127.0.0.1"; };
  listen(std::move(closed));
  EXPECT_EQ(exchange(request("GET", "/page")), "");
}

TEST_F(HttpServerTest, only_pages_of_currently_known_sites_may_connect) {
  auto beside_others = options();
  std::string known;
  beside_others.allows_origin = [&known](std::string_view origin) { return origin == known; };
  listen(std::move(beside_others));
  const std::string knock = upgrade_request("Origin: https://b.example:7600\r\n");
  EXPECT_THAT(exchange(knock), StartsWith("HTTP/1.1 403 "));
  known = "https://b.example:7600";
  auto socket = raw_connection(server_->port());
  send(socket, knock);
  EXPECT_TRUE(run_until([&] { return connections_.size() == 1; }));
  known = "https://c.example:7600";
  EXPECT_THAT(exchange(knock), StartsWith("HTTP/1.1 403 "));
}

TEST_F(HttpServerTest, requests_for_a_foreign_name_are_refused) {
  auto strict = options();
  strict.names = {.any_host = false, .hosts = {"hub.example"}, .origins = {}};
  listen(std::move(strict));
  EXPECT_THAT(exchange(request("GET", "/page")), StartsWith("HTTP/1.1 421 "));
  EXPECT_THAT(exchange("GET /page HTTP/1.1\r\nHost: hub.example\r\nConnection: close\r\n\r\n"),
              StartsWith("HTTP/1.1 200 "));
  EXPECT_THAT(exchange("GET /page HTTP/1.1\r\nHost: " + host() + "\r\nConnection: close\r\n\r\n"),
              StartsWith("HTTP/1.1 200 "));
}

}  // namespace
}  // namespace roomcast::net
