// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/hub_server.h"

#include <deque>
#include <functional>
#include <thread>

#include <boost/asio/io_context.hpp>
#include <gtest/gtest.h>

#include "roomcast/hub/control_message.h"
#include "roomcast/net/websocket_client.h"

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;
namespace pb = wire::pb;

/// Speaks to the hub in bytes; remembers what it said.
class RawClient final : public net::ConnectionHandler {
 public:
  explicit RawClient(std::deque<net::SealedMessagePtr> to_send) : to_send_(std::move(to_send)) {}
  void on_message(net::MessageBuffer message) override {
    auto control = wire::decode_control(message.payload(), wire::Sender::kHub);
    ASSERT_TRUE(control.ok());
    heard.push_back(std::move(*control));
  }
  net::SealedMessagePtr next_message() override {
    if (to_send_.empty()) return nullptr;
    auto message = to_send_.front();
    to_send_.pop_front();
    return message;
  }
  void on_closed(const net::CloseReason& reason) override { closed = reason; }

  std::vector<pb::Control> heard;
  std::optional<net::CloseReason> closed;

 private:
  std::deque<net::SealedMessagePtr> to_send_;
};

net::SealedMessagePtr viewer_join() {
  pb::Control control;
  control.mutable_join()->mutable_viewer();
  return sealed_control(control);
}

class HubServerTest : public testing::Test {
 protected:
  explicit HubServerTest(std::chrono::milliseconds join_within = wire::kJoinDeadline) {
    HubOptions options;
    options.port = 0;
    options.join_within = join_within;
    hub = std::move(*HubServer::open(options));
    thread = std::jthread([this](const std::stop_token& stop) { hub->run(stop); });
  }
  ~HubServerTest() override {
    if (!thread.joinable()) return;
    thread.request_stop();
    io.run_for(100ms);  // so that the clients answer the hub's close frames
    thread.join();
  }

  /// A connected client that is about to say this.
  std::shared_ptr<RawClient> connect(std::deque<net::SealedMessagePtr> to_send) {
    auto client = std::make_shared<RawClient>(std::move(to_send));
    const net::HubUrl url{.host = "127.0.0.1", .port = hub->port()};
    bool answered = false;
    net::connect(io, url, {}, [&](auto connection) {
      answered = true;
      ASSERT_TRUE(connection.ok()) << connection.error().message;
      (*connection)->start(client);
      sockets.push_back(*connection);
    });
    run_until([&] { return answered; });
    return client;
  }

  void run_until(const std::function<bool()>& done) {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    while (!done() && io.run_one_until(give_up) > 0) {
    }
    ASSERT_TRUE(done()) << "nothing happened in 5 s";
  }

  std::unique_ptr<HubServer> hub;
  std::jthread thread;
  boost::asio::io_context io;
  std::vector<std::shared_ptr<net::WebSocketConnection>> sockets;
};

TEST_F(HubServerTest, a_viewer_is_welcomed_and_told_who_is_there) {
  const auto viewer = connect({viewer_join()});
  run_until([&] { return viewer->heard.size() >= 2; });
  EXPECT_TRUE(viewer->heard[0].has_welcome());
  EXPECT_TRUE(viewer->heard[1].has_roster());
}

TEST_F(HubServerTest, nonsense_is_answered_with_a_reason_and_a_closed_door) {
  const auto stranger =
      connect({net::seal(net::MessageBuffer(std::vector<std::uint8_t>{1, 2, 3}))});
  run_until([&] { return stranger->closed.has_value(); });
  ASSERT_EQ(stranger->heard.size(), 1u);
  EXPECT_EQ(stranger->heard[0].error().code(), pb::ERROR_MALFORMED);
  EXPECT_EQ(stranger->closed->code, net::close_code::kPolicy);
  EXPECT_EQ(stranger->closed->sentence, stranger->heard[0].error().sentence());
}

TEST_F(HubServerTest, nonsense_of_one_does_not_harm_another) {
  const auto viewer = connect({viewer_join()});
  run_until([&] { return viewer->heard.size() >= 2; });
  const auto stranger =
      connect({net::seal(net::MessageBuffer(std::vector<std::uint8_t>{1, 2, 3}))});
  run_until([&] { return stranger->closed.has_value(); });
  const auto another = connect({viewer_join()});
  run_until([&] { return another->heard.size() >= 2 && viewer->heard.size() >= 3; });
  EXPECT_FALSE(viewer->closed);
  EXPECT_EQ(viewer->heard.back().roster().viewers_size(), 2);
}

class ImpatientHubTest : public HubServerTest {
 protected:
  ImpatientHubTest() : HubServerTest(50ms) {}
};

TEST_F(ImpatientHubTest, who_says_nothing_is_shown_the_door) {
  const auto silent = connect({});
  run_until([&] { return silent->closed.has_value(); });
  EXPECT_EQ(silent->heard.at(0).error().code(), pb::ERROR_UNEXPECTED);
}

TEST_F(HubServerTest, joining_twice_ends_the_connection) {
  const auto viewer = connect({viewer_join(), viewer_join()});
  run_until([&] { return viewer->closed.has_value(); });
  EXPECT_EQ(viewer->heard.back().error().code(), pb::ERROR_UNEXPECTED);
}

TEST_F(HubServerTest, control_messages_of_strangers_are_small) {
  const auto stranger = connect({net::seal(
      net::MessageBuffer(std::vector<std::uint8_t>(wire::kMaxControlFromClientBytes + 1, 0)))});
  run_until([&] { return stranger->closed.has_value(); });
  EXPECT_EQ(stranger->closed->code, net::close_code::kTooLarge);
}

TEST_F(HubServerTest, so_many_may_wait_at_the_door_and_no_more) {
  std::vector<std::shared_ptr<RawClient>> crowd;
  for (std::size_t i = 0; i < wire::kMaxUnjoinedConnections; ++i) crowd.push_back(connect({}));
  const auto one_more = connect({});
  run_until([&] { return one_more->closed.has_value(); });
  EXPECT_EQ(one_more->closed->code, net::close_code::kTryAgainLater);
}

TEST_F(HubServerTest, a_stopping_hub_says_good_bye) {
  const auto viewer = connect({viewer_join()});
  run_until([&] { return viewer->heard.size() >= 2; });
  thread.request_stop();
  run_until([&] { return viewer->closed.has_value(); });
  EXPECT_EQ(viewer->closed->code, net::close_code::kGoingAway);
  io.run_for(100ms);  // for the end of the TCP connection
  thread.join();
}

TEST_F(HubServerTest, a_port_in_use_is_named) {
  HubOptions options;
  options.port = hub->port();
  const auto second = HubServer::open(options);
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.error().code, ErrorCode::kUnavailable);
  EXPECT_NE(second.error().message.find(std::to_string(hub->port())), std::string::npos);
}

TEST(HubServer, a_web_directory_without_a_page_is_refused) {
  HubOptions options;
  options.port = 0;
  options.web_directory = "/nonexistent";
  const auto opened = HubServer::open(options);
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(opened.error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::hub
