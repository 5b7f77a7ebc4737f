// SPDX-License-Identifier: Apache-2.0
// With a real server.
#include "roomcast/hub/federation/nats/nats_session.h"

#include <functional>

#include <boost/asio/executor_work_guard.hpp>
#include <gtest/gtest.h>

#include "roomcast/hub/federation/nats/nats_server_fixture.h"

namespace roomcast::hub::federation {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kPlenty = 64u << 20;

class NatsSessionTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!NatsServer::is_installed()) GTEST_SKIP() << "nats-server is not installed";
  }
  std::shared_ptr<NatsSession> connect(const NatsServer& server) {
    std::shared_ptr<NatsSession> session;
    log_in_to_nats(io, {.servers = {server.url()}}, [&](Result<NatsConnection> made) {
      session = std::make_shared<NatsSession>(*std::move(made));
    });
    run_until([&] { return session != nullptr; });
    session->start(
        {.on_message = [this](std::string_view subject,
                              auto message) { received.emplace_back(subject, message.size()); },
         .on_lost = [this] { ++gone; }});
    return session;
  }
  void run_until(const std::function<bool()>& done) {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    auto work = boost::asio::make_work_guard(io);
    io.restart();
    while (!done() && io.run_one_until(give_up) > 0) {
    }
    ASSERT_TRUE(done()) << "nothing happened in 5 s";
  }

  boost::asio::io_context io;
  std::vector<std::pair<std::string, std::size_t>> received;
  int gone = 0;
};

TEST_F(NatsSessionTest, messages_of_any_length_arrive_whole) {
  const NatsServer server;
  const auto speaker = connect(server), listener = connect(server);
  const std::vector<std::uint8_t> message(1 << 20);
  ASSERT_EQ(listener->max_message_bytes(), message.size());
  listener->subscribe("a");
  run_until([&] {  // a subscription takes effect with a delay
    speaker->publish("a", {}, kPlenty);
    io.run_for(1ms);
    return !received.empty();
  });
  speaker->publish("a", message, kPlenty);
  run_until([&] { return received.back().second == 1 << 20; });
}

TEST_F(NatsSessionTest, gets_no_messages_after_unsubscribe) {
  const NatsServer server;
  const auto speaker = connect(server), listener = connect(server);
  listener->subscribe("a");
  listener->subscribe("b");
  const auto say_until_heard = [&](const std::vector<std::string>& subjects) {
    received.clear();
    run_until([&] {
      for (const std::string& subject : subjects) speaker->publish(subject, {}, kPlenty);
      io.run_for(1ms);
      return !received.empty() && received.back().first == "b";
    });
  };
  say_until_heard({"a", "b"});
  listener->unsubscribe("a");
  say_until_heard({"b"});  // after this the server has processed it
  say_until_heard({"a", "b"});
  for (const auto& [subject, size] : received) EXPECT_EQ(subject, "b");
}

TEST_F(NatsSessionTest, a_pinged_server_answers) {
  const NatsServer server;
  const auto session = connect(server);
  io.run_for(20ms);
  const HostTime before = session->last_received();
  session->ping();
  run_until([&] { return session->last_received() > before; });
}

TEST_F(NatsSessionTest, answers_pings) {
  const NatsServer server("ping_interval: \"100ms\"\nping_max: 1\n");
  const auto session = connect(server);
  for (int times = 0; times < 4; ++times) {
    run_until([&, before = session->last_received()] { return session->last_received() > before; });
  }
  EXPECT_EQ(gone, 0) << "a server disconnects a client that does not answer";
}

TEST_F(NatsSessionTest, reports_a_lost_connection_once) {
  auto server = std::make_unique<NatsServer>();
  const auto session = connect(*server), aborted = connect(*server);
  aborted->abort();
  run_until([&] { return gone == 1; });
  server.reset();
  run_until([&] { return gone == 2; });
  session->stop();
  io.run_for(10ms);
  EXPECT_EQ(gone, 2);
}

TEST_F(NatsSessionTest, limits_unsent_bytes) {
  const NatsServer server;
  const auto session = connect(server);
  server.hang();
  const std::vector<std::uint8_t> message(100'000);
  int sent = 0;
  while (session->publish("a", message, 1'000'000) && sent < 1'000) ++sent;
  EXPECT_LT(sent, 1'000) << "100 MB are more than the system keeps";
}

}  // namespace
}  // namespace roomcast::hub::federation
