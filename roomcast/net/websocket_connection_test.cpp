// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/websocket_connection.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/net/websocket_pair_fixture.h"

namespace roomcast::net {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;

using WebSocketConnectionTest = WebSocketPairTest;

TEST_F(WebSocketConnectionTest, carries_messages_both_ways_in_order) {
  open_both();
  for (const auto* text : {"a", "b", "c"}) client_.send(message_of(text));
  server_.send(message_of("hello"));
  ASSERT_TRUE(run_until(
      [&] { return server_.handler->messages.size() == 3 && !client_.handler->messages.empty(); }));
  EXPECT_THAT(server_.handler->messages, ElementsAre(bytes_of("a"), bytes_of("b"), bytes_of("c")));
  EXPECT_THAT(client_.handler->messages, ElementsAre(bytes_of("hello")));
  EXPECT_EQ(server_.connection->counters().messages_in, 3U);
  EXPECT_EQ(server_.connection->counters().messages_out, 1U);
  EXPECT_EQ(server_.connection->counters().bytes_out, 2U + 5U);
  EXPECT_EQ(server_.connection->counters().bytes_in, 3U * (6U + 1U));
}

TEST_F(WebSocketConnectionTest, reports_the_end_of_the_messages_of_each_read) {
  open_server();
  const auto message =
      frame_message(MessageBuffer(bytes_of("part")), Opcode::kBinary, MaskKey{1, 2, 3, 4});
  Bytes three;
  for (int i = 0; i < 3; ++i) {
    three.insert(three.end(), message->wire_bytes().begin(), message->wire_bytes().end());
  }
  boost::asio::write(*peer_, boost::asio::buffer(three));
  ASSERT_TRUE(run_until([&] { return server_.handler->messages.size() == 3; }));
  EXPECT_THAT(server_.handler->messages_when_read_done.back(), 3U);
  const auto& done = server_.handler->messages_when_read_done;
  EXPECT_THAT(std::count(done.begin(), done.end(), 1U) + std::count(done.begin(), done.end(), 2U),
              0);
}

TEST_F(WebSocketConnectionTest, carries_messages_of_two_mebibytes_unharmed) {
  open_both();
  const Bytes payload = pattern(kTwoMiB);
  client_.send(frame_message(MessageBuffer(payload)));
  server_.send(frame_message(MessageBuffer(payload)));
  ASSERT_TRUE(run_until(
      [&] { return !server_.handler->messages.empty() && !client_.handler->messages.empty(); }));
  EXPECT_EQ(server_.handler->messages[0], payload);
  EXPECT_EQ(client_.handler->messages[0], payload);
}

TEST_F(WebSocketConnectionTest, one_framed_message_goes_to_many_without_a_copy) {
  open_both();
  const auto message = message_of("shared");
  server_.send(message);
  client_.send(message);
  ASSERT_TRUE(run_until(
      [&] { return !server_.handler->messages.empty() && !client_.handler->messages.empty(); }));
  EXPECT_EQ(bytes_of("shared"), Bytes(message->payload().begin(), message->payload().end()));
  EXPECT_EQ(message.use_count(), 1);
}

TEST_F(WebSocketConnectionTest, bytes_that_came_with_the_handshake_are_not_lost) {
  auto sockets = connected_sockets();
  const auto early = message_of("early");
  client_ = open(std::move(sockets.ours), options(WebSocketRole::kClient), early->wire_bytes());
  ASSERT_TRUE(run_until([&] { return !client_.handler->messages.empty(); }));
  EXPECT_THAT(client_.handler->messages, ElementsAre(bytes_of("early")));
}

TEST_F(WebSocketConnectionTest, a_peer_that_does_not_read_does_not_block_the_program) {
  open_server();
  const auto large = frame_message(MessageBuffer(pattern(64 * 1024)));
  constexpr int kOffered = 1000;  // 64 MB: more than any socket buffer
  for (int i = 0; i < kOffered; ++i) server_.handler->to_send.push_back(large);
  server_.connection->wake();
  int given_before = -1;
  ASSERT_TRUE(run_until([&] {
    run_ready();
    return std::exchange(given_before, server_.handler->times_given) ==
           server_.handler->times_given;
  }));
  const int given = server_.handler->times_given;
  EXPECT_LT(given, kOffered / 2);
  EXPECT_LE(server_.connection->unwritten_bytes(), std::size_t{256 + 64} * 1024);
  server_.connection->wake();
  run_ready();
  EXPECT_EQ(server_.handler->times_given, given) << "waking does not make room";

  const auto received = peer_receives(kOffered);
  EXPECT_EQ(received.size(), static_cast<std::size_t>(kOffered)) << "and then it goes on";
}

TEST_F(WebSocketConnectionTest, a_congested_socket_is_offered_little_at_a_time) {
  open_server();
  const auto message = frame_message(MessageBuffer(pattern(16 * 1024)));
  for (int i = 0; i < 4000; ++i) server_.handler->to_send.push_back(message);
  server_.connection->wake();
  int given_before = -1;
  ASSERT_TRUE(run_until([&] {
    run_ready();
    return std::exchange(given_before, server_.handler->times_given) ==
           server_.handler->times_given;
  }));
  // From now on the peer reads, and the server writes as space permits.
  std::vector<char> sink(64 * 1024);
  std::size_t highest = 0;
  for (int i = 0; i < 200; ++i) {
    peer_takes(sink);
    run_ready();
    if (i > 2) highest = std::max(highest, server_.connection->unwritten_bytes());
  }
  EXPECT_GT(server_.handler->times_given, given_before) << "it does go on";
  EXPECT_LE(highest, message->wire_bytes().size()) << "what waits, waits with the handler";
}

TEST_F(WebSocketConnectionTest, a_pong_waits_for_the_end_of_the_message_being_written) {
  open_server();
  server_.send(frame_message(MessageBuffer(pattern(kTwoMiB))));
  run_ready();
  ASSERT_GT(server_.connection->unwritten_bytes(), 0U) << "the message must still be on its way";
  peer_sends(Opcode::kPing, "now?");
  run_ready();
  EXPECT_THAT(peer_receives(2), ElementsAre("message of " + std::to_string(kTwoMiB), "pong now?"));
}

TEST_F(WebSocketConnectionTest, many_pings_of_a_peer_that_does_not_read_cost_one_pong) {
  open_server();
  server_.send(frame_message(MessageBuffer(pattern(kTwoMiB))));
  run_ready();
  ASSERT_GT(server_.connection->unwritten_bytes(), 0U);
  const std::size_t before = server_.connection->unwritten_bytes();
  for (int i = 0; i < 1000; ++i) peer_sends(Opcode::kPing, std::to_string(i));
  run_ready();
  EXPECT_LE(server_.connection->unwritten_bytes(), before);
  EXPECT_THAT(peer_receives(2), ElementsAre("message of " + std::to_string(kTwoMiB), "pong 999"));
}

TEST_F(WebSocketConnectionTest, knows_its_peers_address) {
  open_server();
  EXPECT_EQ(server_.connection->peer_address(),
            "127.0.0.1:" + std::to_string(peer_->local_endpoint().port()));
}

}  // namespace
}  // namespace roomcast::net
