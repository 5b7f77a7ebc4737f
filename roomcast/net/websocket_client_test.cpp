// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/websocket_client.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/net/http_server.h"
#include "roomcast/net/loopback_fixture.h"
#include "roomcast/net/tls/tls_fixture.h"

namespace roomcast::net {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

using Outcome = Result<std::shared_ptr<WebSocketConnection>>;

class WebSocketClientTest : public LoopbackTest {
 protected:
  static HubUrl url(std::uint16_t port) { return {"127.0.0.1", port, "/ws"}; }

  Outcome outcome_of(const HubUrl& url, ClientOptions options = {}) {
    std::optional<Outcome> outcome;
    connect(io_, url, std::move(options), [&](Outcome got) { outcome = std::move(got); });
    EXPECT_FALSE(outcome.has_value()) << "never from within connect()";
    EXPECT_TRUE(run_until([&] { return outcome.has_value(); }));
    return *std::move(outcome);
  }

  /// Runs a server that sends these bytes to its client; returns the outcome of connecting to it.
  Outcome outcome_when_answered(std::string answer, bool then_close) {
    Tcp::acceptor acceptor(io_, Tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0));
    std::optional<Tcp::socket> socket;
    acceptor.async_accept([&](boost::system::error_code error, Tcp::socket accepted) {
      ASSERT_FALSE(error);
      send(accepted, answer);
      if (then_close) accepted.shutdown(Tcp::socket::shutdown_send);
      socket = std::move(accepted);
    });
    return outcome_of(url(acceptor.local_endpoint().port()), {.connect_within = 200ms});
  }

  static void expect_error(const Outcome& outcome, ErrorCode code, std::string_view part) {
    ASSERT_FALSE(outcome.ok());
    EXPECT_EQ(outcome.error().code, code) << outcome.error().message;
    EXPECT_THAT(outcome.error().message, HasSubstr(part));
  }

  std::unique_ptr<HttpServer> listen(HttpServerOptions options = {}) {
    options.port = 0;
    if (!options.on_websocket) {
      options.on_websocket = [this](auto connection, std::size_t) {
        served_ = std::move(connection);
        return handler_;
      };
    }
    auto server = HttpServer::listen(io_, std::move(options));
    EXPECT_TRUE(server.ok());
    return *std::move(server);
  }

  std::shared_ptr<WebSocketConnection> served_;
  std::shared_ptr<RecordingHandler> handler_ = std::make_shared<RecordingHandler>();
};

TEST_F(WebSocketClientTest, connects_and_exchanges_messages) {
  const auto server = listen();
  auto connection = outcome_of(url(server->port()));
  ASSERT_TRUE(connection.ok()) << connection.error().message;
  const auto client = std::make_shared<RecordingHandler>();
  client->to_send.push_back(message_of("to the hub"));
  handler_->to_send.push_back(message_of("to the client"));
  (*connection)->start(client);
  served_->wake();
  ASSERT_TRUE(run_until([&] { return !client->messages.empty() && !handler_->messages.empty(); }));
  EXPECT_EQ(std::string(client->messages[0].begin(), client->messages[0].end()), "to the client");
}

TEST_F(WebSocketClientTest, connects_by_name) {
  const auto server = listen();
  EXPECT_TRUE(outcome_of({"localhost", server->port(), "/ws"}).ok());
}

TEST_F(WebSocketClientTest, messages_sent_before_start_are_kept) {
  handler_->to_send.push_back(message_of("welcome"));
  const auto server = listen();
  auto connection = outcome_of(url(server->port()));
  ASSERT_TRUE(connection.ok());
  ASSERT_TRUE(run_until([&] { return handler_->times_given == 1; }));
  run_ready();
  const auto client = std::make_shared<RecordingHandler>();
  (*connection)->start(client);
  ASSERT_TRUE(run_until([&] { return client->messages.size() == 1; }));
}

TEST_F(WebSocketClientTest, reports_that_no_program_listens) {
  std::uint16_t port = 0;
  {
    const Tcp::acceptor gone(io_, Tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0));
    port = gone.local_endpoint().port();
  }
  expect_error(outcome_of(url(port)), ErrorCode::kUnavailable, "is the hub running?");
}

TEST_F(WebSocketClientTest, reports_an_unknown_host) {
  // A label of a name has at most 63 characters (RFC 1035), so this fails without a network query.
  const std::string name = std::string(64, 'a') + ".invalid";
  expect_error(outcome_of({name, 7600, "/ws"}), ErrorCode::kNotFound, name);
}

TEST_F(WebSocketClientTest, reports_a_server_that_is_no_hub) {
  expect_error(outcome_when_answered("HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nhi", false),
               ErrorCode::kUnsupported, "HTTP status 200");
  expect_error(outcome_when_answered("SSH-2.0-OpenSSH_9.2\r\n", false), ErrorCode::kUnsupported,
               "does not answer like a roomcast hub");
  expect_error(outcome_when_answered("HTTP/1.1 101 Switching Protocols\r\n\r\n", false),
               ErrorCode::kUnsupported, "does not follow the WebSocket handshake");
  expect_error(outcome_when_answered("", true), ErrorCode::kUnavailable, "without an answer");
}

TEST_F(WebSocketClientTest, survives_an_endless_answer) {
  expect_error(outcome_when_answered("HTTP/1.1 200 OK\r\nX: " + std::string(1 << 20, 'x'), false),
               ErrorCode::kUnsupported, "does not answer like a roomcast hub");
  expect_error(
      outcome_when_answered(
          "HTTP/1.1 200 OK\r\nContent-Length: 1000000\r\n\r\n" + std::string(10'000, 'x'), false),
      ErrorCode::kUnsupported, "HTTP status 200");
}

TEST_F(WebSocketClientTest, gives_up_on_a_silent_server) {
  const auto begin = std::chrono::steady_clock::now();
  expect_error(outcome_when_answered("", false), ErrorCode::kUnavailable, "in time");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
}

TEST_F(WebSocketClientTest, repeats_the_hubs_reason_for_a_refusal) {
  const auto server = listen({.subprotocol = "roomcast.v2"});
  expect_error(outcome_of(url(server->port())), ErrorCode::kUnsupported,
               "The WebSocket subprotocol must be roomcast.v2.");
}

TEST_F(WebSocketClientTest, reports_a_full_hub) {
  const auto server = listen({.max_connections = 0});
  expect_error(outcome_of(url(server->port())), ErrorCode::kUnavailable, "full");
}

TEST_F(WebSocketClientTest, a_proxy_without_its_hub_may_be_tried_again) {
  for (const std::string status : {"502 Bad Gateway", "504 Gateway Timeout"}) {
    expect_error(
        outcome_when_answered("HTTP/1.1 " + status + "\r\nContent-Length: 0\r\n\r\n", false),
        ErrorCode::kUnavailable, "try again later");
  }
}

TEST_F(WebSocketClientTest, a_cancelled_attempt_does_not_call_back) {
  const auto server = listen();
  bool called = false;
  const auto attempt = connect(io_, url(server->port()), {}, [&](auto) { called = true; });
  attempt->cancel();
  server->stop();
  io_.run_for(5s);
  EXPECT_TRUE(io_.stopped());
  EXPECT_FALSE(called);
  attempt->cancel();
}

/// A server with its own certificate.
class EncryptedClientTest : public WebSocketClientTest {
 protected:
  HubUrl pinned_url() const {
    return {"127.0.0.1", server_->port(), "/ws", true, certificate_.fingerprint()};
  }

  Certificate certificate_ = self_signed();
  std::unique_ptr<HttpServer> server_ = listen({.tls = server_context(certificate_)});
};

TEST_F(EncryptedClientTest, exchanges_messages_with_a_server_of_the_given_fingerprint) {
  auto connection = outcome_of(pinned_url());
  ASSERT_TRUE(connection.ok()) << connection.error().message;
  const auto client = std::make_shared<RecordingHandler>();
  const std::string large(300'000, 'x');
  client->to_send = {message_of("hello"), message_of(std::string(10'000, 'y'))};
  handler_->to_send = {message_of(large), message_of("good day")};
  served_->wake();
  (*connection)->start(client);
  EXPECT_TRUE(
      run_until([&] { return handler_->messages.size() == 2 && client->messages.size() == 2; }));
  EXPECT_EQ(client->messages.front().size(), large.size());
  (*connection)->close(close_code::kNormal, "done");
  EXPECT_TRUE(run_until([&] { return handler_->closed.has_value(); }));
  EXPECT_EQ(handler_->closed->code, close_code::kNormal);
}

TEST_F(EncryptedClientTest, refuses_a_server_with_another_certificate) {
  HubUrl url = pinned_url();
  url.pinned = self_signed().fingerprint();
  expect_error(outcome_of(url), ErrorCode::kUnsupported, "another fingerprint");
  EXPECT_EQ(served_, nullptr);
}

TEST_F(EncryptedClientTest, refuses_a_server_with_an_untrusted_certificate) {
  HubUrl url = pinned_url();
  url.pinned.reset();
  expect_error(outcome_of(url), ErrorCode::kUnsupported, "untrusted certificate");
  EXPECT_EQ(served_, nullptr);
}

TEST_F(EncryptedClientTest, reports_that_only_one_side_encrypts) {
  expect_error(outcome_of(url(server_->port())), ErrorCode::kUnsupported, "wss://");
  HubUrl to_plain = pinned_url();
  const auto plain = listen();
  to_plain.port = plain->port();
  expect_error(outcome_of(to_plain), ErrorCode::kUnsupported, "does not speak TLS");
}

TEST_F(EncryptedClientTest, gives_up_on_a_server_that_never_shakes_hands) {
  Tcp::acceptor silent(io_, Tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0));
  HubUrl url = pinned_url();
  url.port = silent.local_endpoint().port();
  expect_error(outcome_of(url, {.connect_within = 100ms}), ErrorCode::kUnavailable, "in time");
}

}  // namespace
}  // namespace roomcast::net
