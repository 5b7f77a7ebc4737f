// SPDX-License-Identifier: Apache-2.0
// With a scripted server. The answers of real servers are tested in nats_client_test.cpp and
// tests/network/nats_access.test.mjs.
#include "roomcast/hub/federation/nats/nats_login.h"

#include <functional>
#include <memory>
#include <optional>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/write.hpp>
#include <gtest/gtest.h>

namespace roomcast::hub::federation {
namespace {

using namespace std::chrono_literals;
namespace asio = boost::asio;
using Tcp = asio::ip::tcp;

/// Sends one text to a new client, and another one after the client's first message.
class Answerer {
 public:
  Answerer(asio::io_context& io, std::string greeting, std::string answer)
      : acceptor_(io, {asio::ip::address_v4::loopback(), 0}),
        socket_(io),
        greeting_(std::move(greeting)),
        answer_(std::move(answer)) {
    // Handlers may come after the server has gone.
    acceptor_.async_accept(socket_, [this, here = std::weak_ptr(here_)](auto error) {
      if (error || here.expired()) return;
      asio::write(socket_, asio::buffer(greeting_), ignored_);
      socket_.async_read_some(asio::buffer(heard_), [this, here](auto end, std::size_t size) {
        if (here.expired()) return;
        received.assign(heard_.data(), end ? 0 : size);
        asio::write(socket_, asio::buffer(answer_), ignored_);
      });
    });
  }
  [[nodiscard]] std::string url() const {
    return "nats://127.0.0.1:" + std::to_string(acceptor_.local_endpoint().port());
  }

  std::string received;

 private:
  Tcp::acceptor acceptor_;
  Tcp::socket socket_;
  const std::string greeting_, answer_;
  std::array<char, 4096> heard_{};
  boost::system::error_code ignored_;
  std::shared_ptr<int> here_ = std::make_shared<int>();
};

constexpr char kInfo[] = "INFO {\"max_payload\": 1000, \"nonce\": \"n\"}\r\n";

class NatsLoginTest : public testing::Test {
 protected:
  Result<NatsConnection> log_in(NatsOptions options) {
    std::optional<Result<NatsConnection>> made;
    log_in_to_nats(io, std::move(options), [&](auto result) { made = std::move(result); });
    EXPECT_FALSE(made) << "never from within log_in_to_nats()";
    auto work = asio::make_work_guard(io);
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    while (!made && io.run_one_until(give_up) > 0) {
    }
    if (!made) return Error{ErrorCode::kMalformed, "no answer in 5 s"};
    return *std::move(made);
  }

  asio::io_context io;
};

TEST_F(NatsLoginTest, keeps_bytes_after_the_login) {
  Answerer server(io, kInfo, "+OK\r\nPONG\r\nPING\r\nMS");
  auto made = log_in({.servers = {server.url()}});
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(std::string(made->received.begin(), made->received.end()), "PING\r\nMS");
  EXPECT_EQ(made->info.max_message_bytes, 1000u);
  EXPECT_TRUE(server.received.starts_with("CONNECT {") &&
              server.received.ends_with("}\r\nPING\r\n"));
}

TEST_F(NatsLoginTest, uses_the_first_server_that_answers) {
  Answerer silent(io, "", ""), speaks(io, kInfo, "PONG\r\n"), not_asked(io, kInfo, "PONG\r\n");
  const std::string closed_port = Answerer(io, "", "").url();
  auto made = log_in({.servers = {closed_port, silent.url(), speaks.url(), not_asked.url()}});
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(made->server, speaks.url());
  EXPECT_TRUE(not_asked.received.empty());
}

TEST_F(NatsLoginTest, names_all_silent_servers_without_passwords) {
  Answerer silent(io, "INFO {", "");
  const std::string closed_port = Answerer(io, "", "").url();
  const auto made = log_in({.servers = {silent.url(), "nats://u:secret@" + closed_port.substr(7)}});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::kUnavailable);
  EXPECT_EQ(made.error().message, "no NATS server answers at " + silent.url() + ", " + closed_port);
}

TEST_F(NatsLoginTest, distinguishes_other_servers_from_a_refusal) {
  const auto error_of = [this](const char* greeting, const char* answer) {
    Answerer server(io, greeting, answer);
    const auto made = log_in({.servers = {server.url()}});
    return made ? "" : made.error().message;
  };
  EXPECT_NE(error_of("HTTP/1.1 400 Bad Request\r\n", "").find("is no NATS server"),
            std::string::npos);
  EXPECT_NE(error_of("INFO nothing\r\n", "").find("is no NATS server"), std::string::npos);
  EXPECT_NE(error_of(kInfo, "-ERR 'Authorization Violation'\r\n").find("refuses this hub"),
            std::string::npos);
  EXPECT_NE(error_of(kInfo, "-ERR 'maximum connections exceeded'\r\n").find("rejects this hub"),
            std::string::npos);
}

TEST_F(NatsLoginTest, reports_a_refusal_if_no_other_server_accepts) {
  Answerer refuses(io, kInfo, "-ERR 'Authorization Violation'\r\n");
  const std::string closed_port = Answerer(io, "", "").url();
  const auto made = log_in({.servers = {refuses.url(), closed_port}});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::kClosed);
}

TEST_F(NatsLoginTest, sends_no_credentials_without_encryption) {
  Answerer server(io, kInfo, "PONG\r\n");
  const auto made = log_in({.servers = {"tls" + server.url().substr(4)}});
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().message.find("offers no TLS"), std::string::npos);
  io.run_for(1ms);
  EXPECT_TRUE(server.received.empty());
}

TEST_F(NatsLoginTest, a_cancelled_login_calls_no_handler) {
  Answerer server(io, kInfo, "PONG\r\n");
  bool called = false;
  const auto attempt =
      log_in_to_nats(io, {.servers = {server.url()}}, [&](auto) { called = true; });
  io.run_one();  // the attempt has begun
  attempt->cancel();
  io.run_for(20ms);
  EXPECT_FALSE(called);
}

}  // namespace
}  // namespace roomcast::hub::federation
