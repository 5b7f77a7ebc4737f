// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/server/hub_server.h"

#include <algorithm>

#include "roomcast/hub/server/hub_server_fixture.h"

namespace roomcast::hub {
namespace {

TEST_F(HubServerTest, a_viewer_gets_a_welcome_and_the_roster) {
  const auto viewer = connect(join_as_viewer());
  run_until([&] { return viewer->received.size() >= 2; });
  EXPECT_TRUE(viewer->received[0].has_welcome());
  EXPECT_TRUE(viewer->received[1].has_roster());
}

TEST_F(HubServerTest, an_invalid_message_is_answered_with_a_reason_and_a_close) {
  const auto stranger =
      connect({net::frame_message(net::MessageBuffer(std::vector<std::uint8_t>{1, 2, 3}))});
  run_until([&] { return stranger->closed.has_value(); });
  ASSERT_EQ(stranger->received.size(), 1u);
  EXPECT_EQ(stranger->received[0].error().code(), pb::ERROR_MALFORMED);
  EXPECT_EQ(stranger->closed->code, net::close_code::kPolicy);
  EXPECT_EQ(stranger->closed->sentence, stranger->received[0].error().sentence());
}

TEST_F(HubServerTest, an_invalid_message_leaves_other_clients_connected) {
  const auto viewer = connect(join_as_viewer());
  run_until([&] { return viewer->received.size() >= 2; });
  const auto stranger =
      connect({net::frame_message(net::MessageBuffer(std::vector<std::uint8_t>{1, 2, 3}))});
  run_until([&] { return stranger->closed.has_value(); });
  const auto another = connect(join_as_viewer());
  run_until([&] { return another->received.size() >= 2 && viewer->received.size() >= 3; });
  EXPECT_FALSE(viewer->closed);
  EXPECT_EQ(viewer->received.back().roster().viewers_size(), 2);
}

TEST_F(HubServerTest, clock_pings_are_answered_with_room_time) {
  const auto before = SteadyClock().now();
  const auto viewer = connect({framed_control(join_as_viewer()), clock_ping(5)});
  const auto pong = [&] {
    return std::ranges::find_if(viewer->received, [](const auto& m) { return m.has_clock_pong(); });
  };
  run_until([&] { return pong() != viewer->received.end(); });
  EXPECT_EQ(pong()->clock_pong().client_ns(), 5U);
  const HostTime room_time(nanoseconds(pong()->clock_pong().hub_ns()));
  EXPECT_GE(room_time, before);
  EXPECT_LE(room_time, SteadyClock().now());
}

/// Runs the same hub on one thread and on several.
class HubOnThreadsTest : public HubServerTest, public testing::WithParamInterface<std::size_t> {
 protected:
  HubOnThreadsTest() : HubServerTest({.threads = GetParam()}) {}
};
INSTANTIATE_TEST_SUITE_P(Threads, HubOnThreadsTest, testing::Values(1, 2, 3));

TEST_P(HubOnThreadsTest, all_viewers_get_all_frames_in_order) {
  std::vector<std::shared_ptr<RawClient>> viewers;
  for (int i = 0; i < 5; ++i) viewers.push_back(connect(join_as_viewer()));
  for (const auto& viewer : viewers) run_until([&] { return viewer->received.size() >= 2; });
  const auto sensor = connect(join_as_sensor("left"));
  run_until([&] { return sensor->received.size() >= 1 && sensor->received[0].has_welcome(); });
  constexpr std::uint32_t kFrames = 20;
  for (std::uint32_t seq = 0; seq < kFrames; ++seq) {
    sensor->send(key_frame(seq));
    sockets.back()->wake();
    for (const auto& viewer : viewers) run_until([&] { return viewer->frames.size() > seq; });
  }
  for (const auto& viewer : viewers) {
    for (std::uint32_t seq = 0; seq < kFrames; ++seq) EXPECT_EQ(viewer->frames.at(seq).seq, seq);
  }
}

TEST_P(HubOnThreadsTest, viewers_can_join_and_leave_at_any_time) {
  for (std::size_t round = 0; round < 4; ++round) {
    const auto staying = connect(join_as_viewer());
    run_until([&] { return staying->received.size() >= 2; });
    const auto going = connect(join_as_viewer());
    run_until([&] { return going->received.size() >= 2; });
    sockets.back()->close(net::close_code::kNormal, "");
    run_until([&] {
      return staying->received.back().has_roster() &&
             staying->received.back().roster().viewers_size() == static_cast<int>(round) + 1;
    });
  }
}

class JoinDeadlineTest : public HubServerTest {
 protected:
  JoinDeadlineTest() : HubServerTest({.join_within = 50ms}) {}
};

TEST_F(JoinDeadlineTest, a_silent_connection_is_closed) {
  const auto silent = connect(std::deque<net::FramedMessagePtr>());
  run_until([&] { return silent->closed.has_value(); });
  EXPECT_EQ(silent->received.at(0).error().code(), pb::ERROR_UNEXPECTED);
}

TEST_F(HubServerTest, joining_twice_ends_the_connection) {
  const auto viewer = connect({framed_control(join_as_viewer()), framed_control(join_as_viewer())});
  run_until([&] { return viewer->closed.has_value(); });
  EXPECT_EQ(viewer->received.back().error().code(), pb::ERROR_UNEXPECTED);
}

TEST_F(HubServerTest, limits_control_messages_before_a_join) {
  const auto stranger = connect({net::frame_message(
      net::MessageBuffer(std::vector<std::uint8_t>(wire::kMaxControlFromClientBytes + 1, 0)))});
  run_until([&] { return stranger->closed.has_value(); });
  EXPECT_EQ(stranger->closed->code, net::close_code::kTooLarge);
}

class SmallHubTest : public HubServerTest {
 protected:
  SmallHubTest() : HubServerTest({.limits = {.max_unjoined = 8}}) {}
};

TEST_F(SmallHubTest, limits_unjoined_connections) {
  std::vector<std::shared_ptr<RawClient>> crowd;
  for (int i = 0; i < 8; ++i) crowd.push_back(connect(std::deque<net::FramedMessagePtr>()));
  const auto one_more = connect(std::deque<net::FramedMessagePtr>());
  run_until([&] { return one_more->closed.has_value(); });
  EXPECT_EQ(one_more->closed->code, net::close_code::kTryAgainLater);
}

TEST_P(HubOnThreadsTest, a_stopping_hub_sends_close_frames) {
  std::vector<std::shared_ptr<RawClient>> viewers;
  for (int i = 0; i < 3; ++i) viewers.push_back(connect(join_as_viewer()));
  for (const auto& viewer : viewers) run_until([&] { return viewer->received.size() >= 2; });
  thread.request_stop();
  for (const auto& viewer : viewers) {
    run_until([&] { return viewer->closed.has_value(); });
    EXPECT_EQ(viewer->closed->code, net::close_code::kGoingAway);
  }
  io.run_for(100ms);  // lets the TCP connection end
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
