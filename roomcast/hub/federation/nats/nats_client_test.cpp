// SPDX-License-Identifier: Apache-2.0
// With a real server.
#include "roomcast/hub/federation/nats/nats_client.h"

#include <atomic>
#include <functional>
#include <thread>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <gtest/gtest.h>

#include "roomcast/hub/federation/nats/nats_server_fixture.h"

namespace roomcast::hub::federation {
namespace {

using namespace std::chrono_literals;

std::vector<std::uint8_t> bytes(const std::string& text) {
  return {text.begin(), text.end()};
}

class NatsClientTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!NatsServer::is_installed()) GTEST_SKIP() << "nats-server is not installed";
  }
  Result<std::unique_ptr<NatsClient>> open(const NatsOptions& options) {
    return NatsClient::open(options, io,
                            {.on_message =
                                 [this](std::string_view subject, auto message) {
                                   received.push_back(std::string(subject) + " " +
                                                      std::string(message.begin(), message.end()));
                                 },
                             .on_connected = [this] { ++connected; },
                             .log = {}});
  }
  void run_until(const std::function<bool()>& done) {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    auto work = boost::asio::make_work_guard(io);
    io.restart();
    while (!done() && io.run_one_until(give_up) > 0) {
    }
    ASSERT_TRUE(done()) << "nothing happened in 5 s";
  }
  /// Repeats the message until it is received: a subscription takes effect with a delay.
  void say_until_heard(NatsClient& speaker, const std::string& subject) {
    received.clear();
    boost::asio::steady_timer pace(io);
    std::function<void()> publish_next = [&] {
      speaker.publish(subject, bytes("hello"));
      pace.expires_after(10ms);
      pace.async_wait([&](auto error) {
        if (!error) publish_next();
      });
    };
    publish_next();
    run_until([&] { return !received.empty(); });
    pace.cancel();
    io.poll();
  }

  boost::asio::io_context io;
  std::vector<std::string> received;
  int connected = 0;
};

TEST_F(NatsClientTest, subscribers_receive_messages_in_order) {
  const NatsServer server;
  const auto speaker = *open({.servers = {server.url()}});
  const auto listener = *open({.servers = {server.url()}});
  listener->subscribe("a.*");
  listener->subscribe("b");
  say_until_heard(*speaker, "b");
  received.clear();
  for (int i = 0; i < 50; ++i) {
    speaker->publish(i % 2 == 0 ? "a.x" : "b", bytes(std::to_string(i)));
    speaker->publish("c", bytes("without subscriber"));
  }
  const auto heard_on = [&](char subject) {
    std::vector<std::string> numbers;
    for (const std::string& line : received) {
      const std::string number = line.substr(line.find(' ') + 1);
      if (line[0] == subject && number != "hello") numbers.push_back(number);
    }
    return numbers;
  };
  run_until([&] { return heard_on('a').size() == 25 && heard_on('b').size() == 25; });
  for (int i = 0; i < 50; ++i) {
    const auto numbers = heard_on(i % 2 == 0 ? 'a' : 'b');
    EXPECT_EQ(numbers[static_cast<std::size_t>(i / 2)], std::to_string(i));
  }
}

TEST_F(NatsClientTest, connects_to_a_server_that_starts_later) {
  std::string port;
  { port = NatsServer().port(); }
  const auto speaker = *open({.servers = {"nats://127.0.0.1:" + port}});
  const auto listener = *open({.servers = {"nats://127.0.0.1:" + port}});
  listener->subscribe("a");
  const NatsServer server("", port);
  run_until([&] { return connected == 2; });
  say_until_heard(*speaker, "a");
}

TEST_F(NatsClientTest, connects_to_the_next_server_when_one_is_gone) {
  auto first = std::make_unique<NatsServer>();
  const NatsServer second;
  const auto speaker = *open({.servers = {second.url()}});
  const auto listener = *open({.servers = {first->url(), second.url()}});
  listener->subscribe("a");
  run_until([&] { return connected == 2; });
  first.reset();
  run_until([&] { return connected == 3; });
  say_until_heard(*speaker, "a");
}

TEST_F(NatsClientTest, leaves_a_hanging_server_and_keeps_an_idle_one) {
  const NatsServer first, second;
  const auto quiet = *open({.servers = {second.url(), first.url()}});
  const auto client = *open({.servers = {first.url(), second.url()}});
  run_until([&] { return connected == 2; });
  first.hang();
  run_until([&] { return connected == 3; });
  io.run_for(600ms);
  EXPECT_EQ(connected, 3) << "longer than the one that hung took to be given up";
}

/// A server that accepts each client and disconnects it at once.
class RevolvingDoor {
 public:
  RevolvingDoor() {
    let_in();
    thread_ = std::thread([this] { io_.run(); });
  }
  ~RevolvingDoor() {
    io_.stop();
    thread_.join();
  }
  [[nodiscard]] std::string url() const {
    return "nats://127.0.0.1:" + std::to_string(acceptor_.local_endpoint().port());
  }

  std::atomic<int> let_out = 0;

 private:
  using Tcp = boost::asio::ip::tcp;

  void let_in() {
    acceptor_.async_accept([this](auto error, Tcp::socket client) {
      if (error) return;
      boost::system::error_code ignored;
      std::string received;
      boost::asio::write(client, boost::asio::buffer(std::string("INFO {}\r\n")), ignored);
      boost::asio::read_until(client, boost::asio::dynamic_buffer(received), "PING\r\n", ignored);
      boost::asio::write(client, boost::asio::buffer(std::string("PONG\r\n")), ignored);
      ++let_out;
      let_in();
    });
  }

  boost::asio::io_context io_;
  Tcp::acceptor acceptor_{io_, {boost::asio::ip::address_v4::loopback(), 0}};
  std::thread thread_;
};

TEST_F(NatsClientTest, waits_before_reconnecting_after_an_early_disconnect) {
  RevolvingDoor door;
  const auto client = *open({.servers = {door.url()}});
  auto work = boost::asio::make_work_guard(io);
  io.run_for(700ms);
  EXPECT_GE(door.let_out, 1);
  EXPECT_LE(door.let_out, 3);
}

TEST_F(NatsClientTest, knows_the_servers_message_limit) {
  const NatsServer server("max_payload: 100KB\n");
  const auto client = *open({.servers = {server.url()}});
  EXPECT_EQ(client->max_message_bytes(), 100u * 1024);
}

TEST_F(NatsClientTest, reports_a_missing_or_wrong_password) {
  const NatsServer server("authorization { user: hub, password: right }\n");
  for (const std::string secret : {"", "hub:wrong@"}) {
    const auto refused = open({.servers = {"nats://" + secret + server.url().substr(7)}});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::kClosed);
    EXPECT_NE(refused.error().message.find("refuses this hub"), std::string::npos);
  }
  EXPECT_TRUE(open({.servers = {"nats://hub:right@" + server.url().substr(7)}}));
}

}  // namespace
}  // namespace roomcast::hub::federation
