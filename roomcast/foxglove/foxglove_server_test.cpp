// SPDX-License-Identifier: Apache-2.0
// A server and clients of Boost.Beast on loopback. tests/cli/foxglove.test.mjs uses another client.
#include "roomcast/foxglove/foxglove_server.h"

#include <chrono>
#include <thread>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/field.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace roomcast::foxglove {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using namespace std::chrono_literals;

class Client {
 public:
  explicit Client(std::uint16_t port, const std::string& origin = "",
                  const std::string& protocol = std::string(kSubprotocol),
                  const std::string& host = "127.0.0.1") {
    socket_.next_layer().connect({asio::ip::address_v4::loopback(), port});
    socket_.read_message_max(0);
    socket_.set_option(websocket::stream_base::decorator([=](websocket::request_type& request) {
      request.set(beast::http::field::sec_websocket_protocol, protocol);
      if (!origin.empty()) request.set(beast::http::field::origin, origin);
    }));
    beast::websocket::response_type response;
    socket_.handshake(response, host, "/", failed);
    status = response.result_int();
  }

  void say(const std::string& text) {
    socket_.text(true);
    socket_.write(asio::buffer(text));
  }
  void subscribe(std::uint32_t id, ChannelId channel) {
    say(nlohmann::json{{"op", "subscribe"},
                       {"subscriptions", {{{"id", id}, {"channelId", channel.value}}}}}
            .dump());
  }
  std::string hear() {
    beast::flat_buffer buffer;
    socket_.read(buffer);
    const auto bytes = buffer.cdata();
    return {static_cast<const char*>(bytes.data()), bytes.size()};
  }
  nlohmann::json hear_json() { return nlohmann::json::parse(hear()); }

  boost::system::error_code failed;
  unsigned status = 0;

 private:
  asio::io_context io_;
  websocket::stream<asio::ip::tcp::socket> socket_{io_};
};

constexpr ChannelId kDepthTopic{1}, kPointsTopic{2};
const std::vector<Channel> kChannels = {
    {kDepthTopic, "/s0/depth", recording::FoxgloveKind::kDepth},
    {kPointsTopic, "/points", recording::FoxgloveKind::kPoints}};

class FoxgloveServerTest : public testing::Test {
 protected:
  void SetUp() override {
    auto listening = FoxgloveServer::listen({.port = 0, .max_clients = 2});
    ASSERT_TRUE(listening.ok()) << listening.error().message;
    server = std::move(*listening);
    server->set_channels(kChannels);
  }
  void wait_until_wanted(const std::set<ChannelId>& channels) const {
    const auto deadline = std::chrono::steady_clock::now() + 10s;
    while (server->wanted() != channels && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(1ms);
    EXPECT_EQ(server->wanted(), channels);
  }
  std::unique_ptr<FoxgloveServer> server;
};

TEST_F(FoxgloveServerTest, tells_who_it_is_and_what_it_has) {
  Client client(server->port());
  EXPECT_EQ(client.hear_json()["op"], "serverInfo");
  const auto advertised = client.hear_json();
  EXPECT_EQ(advertised["op"], "advertise");
  EXPECT_EQ(advertised["channels"].size(), 2u);
}

TEST_F(FoxgloveServerTest, sends_a_topic_from_subscribe_to_unsubscribe) {
  Client client(server->port());
  client.hear(), client.hear();
  client.subscribe(9, kDepthTopic);
  wait_until_wanted({kDepthTopic});
  server->publish(kPointsTopic, 1ns, "not wanted");
  server->publish(kDepthTopic, 5ns, "abc");
  const std::string message = client.hear();
  ASSERT_EQ(message.size(), 16u);
  EXPECT_EQ(message.substr(0, 6), std::string("\1\x9\0\0\0\5", 6));
  EXPECT_EQ(message.substr(13), "abc");
  client.say(R"({"op":"unsubscribe","subscriptionIds":[9]})");
  wait_until_wanted({});
}

TEST_F(FoxgloveServerTest, a_client_that_does_not_read_gets_the_newest_and_delays_nobody) {
  Client slow(server->port()), fast(server->port());
  for (Client* client : {&slow, &fast}) {
    client->hear(), client->hear();
    client->subscribe(1, kDepthTopic);
  }
  // Both subscribe before the first message: the set of wanted channels does not tell.
  fast.say("?"), slow.say("?");
  EXPECT_EQ(fast.hear_json()["op"], "status");
  EXPECT_EQ(slow.hear_json()["op"], "status");
  const std::string megabyte(1 << 20, 'x');
  constexpr int kMessages = 60;
  for (int i = 0; i < kMessages; ++i) {
    server->publish(kDepthTopic, nanoseconds(i), megabyte + std::to_string(i));
    EXPECT_EQ(fast.hear().substr(13 + megabyte.size()), std::to_string(i));
  }
  int received = 0;
  for (std::string last; last != std::to_string(kMessages - 1); ++received)
    last = slow.hear().substr(13 + megabyte.size());
  EXPECT_LT(received, kMessages) << "older messages are replaced";
}

TEST_F(FoxgloveServerTest, a_channel_that_has_gone_is_unsubscribed) {
  Client client(server->port());
  client.hear(), client.hear();
  client.subscribe(1, kDepthTopic);
  client.subscribe(2, kPointsTopic);
  wait_until_wanted({kDepthTopic, kPointsTopic});
  server->set_channels({kChannels[1]});
  const auto message = client.hear_json();
  EXPECT_EQ(message["op"], "unadvertise");
  EXPECT_EQ(message["channelIds"], nlohmann::json::array({1}));
  wait_until_wanted({kPointsTopic});
}

TEST_F(FoxgloveServerTest, wrong_requests_are_answered_with_a_sentence) {
  Client client(server->port());
  client.hear(), client.hear();
  for (const char* text : {"{", R"({"op":"setParameters"})",
                           R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":77}]})",
                           R"({"op":"unsubscribe","subscriptionIds":[5]})"}) {
    client.say(text);
    const auto answer = client.hear_json();
    EXPECT_EQ(answer["op"], "status") << text;
    EXPECT_GT(answer["level"], 0) << text;
  }
}

TEST_F(FoxgloveServerTest, a_request_above_the_limit_ends_its_client_alone) {
  Client greedy(server->port()), other(server->port());
  greedy.hear(), greedy.hear();
  EXPECT_THROW((greedy.say(std::string(kMaxRequestBytes + 1, ' ')), greedy.hear()),
               boost::system::system_error);
  EXPECT_EQ(other.hear_json()["op"], "serverInfo");
}

TEST_F(FoxgloveServerTest, foreign_pages_and_other_protocols_are_refused) {
  EXPECT_EQ(Client(server->port(), "https://evil.example").status, 403u);
  EXPECT_EQ(Client(server->port(), "", "roomcast.v1").status, 400u);
  EXPECT_EQ(Client(server->port(), "https://app.foxglove.dev").status, 101u);
}

TEST_F(FoxgloveServerTest, a_rebound_host_is_refused) {
  const std::string protocol(kSubprotocol);
  EXPECT_EQ(Client(server->port(), "", protocol, "evil.example:8765").status, 421u);
  EXPECT_EQ(Client(server->port(), "", protocol, "localhost:8765").status, 101u);
}

TEST_F(FoxgloveServerTest, more_clients_than_allowed_are_dropped) {
  Client first(server->port()), second(server->port());
  first.hear(), second.hear();
  EXPECT_TRUE(Client(server->port()).failed);
}

TEST(FoxgloveServer, a_port_in_use_is_a_sentence) {
  auto first = FoxgloveServer::listen({.port = 0});
  ASSERT_TRUE(first.ok());
  const auto second = FoxgloveServer::listen({.port = (*first)->port()});
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.error().code, ErrorCode::kUnavailable);
  EXPECT_FALSE(FoxgloveServer::listen({.address = "localhost.example"}).ok());
}

TEST(FoxgloveServer, pages_of_this_computer_may_connect) {
  for (const char* origin : {"http://localhost:8080", "http://127.0.0.1", "https://localhost"})
    EXPECT_TRUE(allows_origin(origin, {})) << origin;
  for (const char* origin : {"", "null", "file://", "http://localhost.evil.example",
                             "http://127.0.0.1.evil.example", "ftp://localhost"})
    EXPECT_FALSE(allows_origin(origin, {})) << origin;
}

}  // namespace
}  // namespace roomcast::foxglove
