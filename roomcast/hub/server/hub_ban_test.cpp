// SPDX-License-Identifier: Apache-2.0
// A running hub bans addresses that present bad tokens again and again, in Joins or HTTP requests.
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/hub/server/hub_server.h"
#include "roomcast/hub/server/hub_server_fixture.h"
#include "roomcast/hub/store/hub_store.h"

namespace roomcast::hub {
namespace {

namespace asio = boost::asio;

constexpr std::size_t kFaults = 3;

/// A base class, so that it outlives the hub.
struct HubWithFolder {
  TemporaryFolder folder;
};

class HubBanTest : protected HubWithFolder, public HubServerTest {
 protected:
  explicit HubBanTest(std::vector<std::string> proxies = {})
      : HubServerTest({.data_folder = folder.path(),
                       .metrics_for_anyone = false,
                       .limits = {.bans = {.faults = kFaults}, .proxies = std::move(proxies)}}) {}

  static std::string request(const std::string& path, const std::string& authorization,
                             bool is_last = true) {
    return "GET " + path + " HTTP/1.1\r\nHost: localhost\r\n" +
           (authorization.empty() ? "" : "Authorization: " + authorization + "\r\n") +
           (is_last ? "Connection: close\r\n" : "") + "\r\n";
  }

  /// All bytes that the hub sends before it closes.
  std::string answers(const std::string& requests) {
    asio::ip::tcp::socket socket(io);
    socket.connect({asio::ip::address_v4::loopback(), hub->port()});
    std::string received;
    bool closed = false;
    asio::async_write(socket, asio::buffer(requests), [&](auto, auto) {
      asio::async_read(socket, asio::dynamic_buffer(received), [&](auto, auto) { closed = true; });
    });
    run_until([&] { return closed; });
    return received;
  }

  /// The status code of the answer; 0: no answer.
  int ask(const std::string& path, const std::string& authorization = "") {
    const std::string answer = answers(request(path, authorization));
    return answer.empty() ? 0 : std::stoi(answer.substr(answer.find(' ') + 1));
  }

  void join_with_a_bad_token() {
    pb::Control join = join_as_viewer();
    join.mutable_join()->set_token("guessed");
    const auto guesser = connect(join);
    run_until([&] { return guesser->closed.has_value(); });
  }

  bool is_listened_to() {
    std::optional<bool> let_in;
    net::connect(io, {.host = "127.0.0.1", .port = hub->port()}, {},
                 [&](const auto& connection) { let_in = connection.ok(); });
    run_until([&] { return let_in.has_value(); });
    return *let_in && ask("/healthz") == 200;
  }

  UnixSeconds now = wall_time();
  std::unique_ptr<HubStore> store = *HubStore::open(folder.path(), [this] { return now; });
};

TEST_F(HubBanTest, an_address_with_bad_tokens_is_banned) {
  for (std::size_t i = 0; i < kFaults; ++i) {
    EXPECT_TRUE(is_listened_to());
    join_with_a_bad_token();
  }
  EXPECT_FALSE(is_listened_to());
}

TEST_F(HubBanTest, bad_tokens_of_requests_and_joins_count_alike) {
  join_with_a_bad_token();
  EXPECT_EQ(ask("/api/v1/status", "Bearer guessed"), 401);
  EXPECT_TRUE(is_listened_to());
  EXPECT_EQ(ask("/metrics", "Bearer guessed"), 401);
  EXPECT_FALSE(is_listened_to());
}

TEST_F(HubBanTest, a_ban_applies_to_open_connections) {
  std::string guesses;
  for (std::size_t i = 0; i < kFaults + 1; ++i) {
    guesses += request("/api/v1/rooms", "Bearer guessed", false);
  }
  const std::string received = answers(guesses);
  std::size_t refusals = 0;
  const std::string refusal = "HTTP/1.1 401";
  for (auto at = received.find(refusal); at != std::string::npos;
       at = received.find(refusal, at + 1)) {
    ++refusals;
  }
  EXPECT_EQ(refusals, kFaults);
}

TEST_F(HubBanTest, an_expired_or_missing_token_does_not_ban) {
  now -= 1000;
  const std::string old = store->issue({.room = "*", .role = TokenRole::kAdmin}, 10)->token;
  now += 1000;
  for (std::size_t i = 0; i <= kFaults; ++i) {
    for (const char* path : {"/api/v1/status", "/metrics"}) {
      EXPECT_EQ(ask(path, "Bearer " + old), 401);
      EXPECT_EQ(ask(path), 401);
      EXPECT_EQ(ask(path, "Basic Z3Vlc3NlZDo="), 401);
    }
  }
  EXPECT_TRUE(is_listened_to());
}

class HubBehindAProxyTest : public HubBanTest {
 protected:
  HubBehindAProxyTest() : HubBanTest({"127.0.0.1"}) {}
};

TEST_F(HubBehindAProxyTest, a_proxy_is_not_banned_for_bad_tokens_of_its_clients) {
  for (std::size_t i = 0; i <= kFaults; ++i) {
    join_with_a_bad_token();
    EXPECT_EQ(ask("/api/v1/status", "Bearer guessed"), 401);
  }
  EXPECT_TRUE(is_listened_to());
}

}  // namespace
}  // namespace roomcast::hub
