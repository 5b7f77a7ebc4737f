// SPDX-License-Identifier: Apache-2.0
// With a real TLS server, and a relay that stalls in the middle of a record.
#include <functional>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/steady_timer.hpp>
#include <gtest/gtest.h>

#include "roomcast/hub/federation/nats/nats_client.h"
#include "roomcast/hub/federation/nats/nats_server_fixture.h"
#include "roomcast/hub/federation/nats/stalling_relay_fixture.h"
#include "roomcast/net/tls/certificate.h"

namespace roomcast::hub::federation {
namespace {

using namespace std::chrono_literals;

constexpr auto kLongestWait = 250ms;  // of the rooms' thread, including delays on a loaded machine

class NatsClientTlsTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!NatsServer::is_installed()) GTEST_SKIP() << "nats-server is not installed";
    auto certificate = net::Certificate::make_self_signed({"localhost", "127.0.0.1"});
    ASSERT_TRUE(certificate && certificate->save(file()).ok());
  }
  [[nodiscard]] std::string file() const { return (folder.path() / "server.pem").string(); }
  [[nodiscard]] std::string encrypted() const {
    return "tls { cert_file: \"" + file() + "\", key_file: \"" + file() + "\" }\n";
  }
  [[nodiscard]] NatsOptions options(std::initializer_list<std::string> ports) const {
    NatsOptions options{.servers = {}, .ca_file = file()};
    for (const auto& port : ports) options.servers.push_back("tls://127.0.0.1:" + port);
    return options;
  }
  std::unique_ptr<NatsClient> open(const NatsOptions& options) {
    auto client = NatsClient::open(
        options, io,
        {.on_message = [this](std::string_view, auto message) { heard_bytes += message.size(); },
         .on_connected = [this] { ++connected; },
         .log = {}});
    EXPECT_TRUE(client) << client.error().message;
    return *std::move(client);
  }
  /// Runs the rooms' thread, which must never block.
  void run_until(const std::function<bool()>& done) {
    const auto give_up = std::chrono::steady_clock::now() + 8s;
    boost::asio::steady_timer pace(io);
    std::function<void()> tick = [&] {
      const auto now = std::chrono::steady_clock::now();
      longest_wait = std::max<nanoseconds>(longest_wait, now - last_tick);
      last_tick = now;
      pace.expires_after(5ms);
      pace.async_wait([&](auto error) {
        if (!error) tick();
      });
    };
    last_tick = std::chrono::steady_clock::now();
    tick();
    while (!done() && std::chrono::steady_clock::now() < give_up) io.run_one();
    ASSERT_TRUE(done()) << "nothing happened in 8 s";
  }
  /// Repeats the message until it is received: a subscription takes effect with a delay.
  void run_until_heard(NatsClient& speaker, std::size_t bytes = 10) {
    run_until([&] {
      speaker.publish("a", std::vector<std::uint8_t>(bytes));
      return heard_bytes > 0;
    });
  }
  void run_for(std::chrono::milliseconds time) {
    const auto until = std::chrono::steady_clock::now() + time;
    run_until([until] { return std::chrono::steady_clock::now() >= until; });
  }

  TemporaryFolder folder;
  boost::asio::io_context io;
  std::size_t heard_bytes = 0;
  int connected = 0;
  nanoseconds longest_wait{};
  std::chrono::steady_clock::time_point last_tick;
};

TEST_F(NatsClientTlsTest, messages_are_sent_and_received) {
  const NatsServer server(encrypted());
  const auto speaker = open(options({server.port()})), listener = open(options({server.port()}));
  listener->subscribe("a");
  run_until_heard(*speaker, 1000);
  EXPECT_EQ(heard_bytes % 1000, 0u);
  EXPECT_EQ(listener->max_message_bytes(), 1u << 20);
}

TEST_F(NatsClientTlsTest, a_server_that_stalls_within_a_record_blocks_no_call) {
  const NatsServer server(encrypted());
  StallingRelay relay(server.port());
  const auto speaker = open(options({server.port()}));
  const auto listener = open(options({relay.port(), server.port()}));
  listener->subscribe("a");
  run_until_heard(*speaker);
  relay.stall_after(100);
  speaker->publish("a", std::vector<std::uint8_t>(10'000));
  run_until([&] { return connected == 3; });
  EXPECT_LT(longest_wait, kLongestWait) << "and it goes on at the next server";
}

TEST_F(NatsClientTlsTest, a_server_that_stops_reading_blocks_no_call) {
  const NatsServer server(encrypted());
  StallingRelay relay(server.port());
  const auto client = open(options({relay.port(), server.port()}));
  run_for(100ms);
  relay.stall_client();
  for (int i = 0; i < 100; ++i) client->publish("a", std::vector<std::uint8_t>(500'000));
  run_until([&] { return connected == 2; });
  EXPECT_LT(longest_wait, kLongestWait);
}

TEST_F(NatsClientTlsTest, a_stalling_server_does_not_delay_the_destructor) {
  const NatsServer server(encrypted());
  StallingRelay relay(server.port());
  auto listener = open(options({relay.port()}));
  const auto speaker = open(options({server.port()}));
  listener->subscribe("a");
  run_until_heard(*speaker);
  relay.stall_after(100);
  speaker->publish("a", std::vector<std::uint8_t>(10'000));
  run_for(50ms);
  const auto before = std::chrono::steady_clock::now();
  listener.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - before, kLongestWait);
}

}  // namespace
}  // namespace roomcast::hub::federation
