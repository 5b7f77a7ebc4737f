// SPDX-License-Identifier: Apache-2.0
// How connections end: by agreement, by a protocol violation, by silence, by loss.
#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/net/websocket_connection.h"
#include "roomcast/net/websocket_pair_fixture.h"

namespace roomcast::net {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;

using WebSocketConnectionEnd = WebSocketPairTest;

TEST_F(WebSocketConnectionEnd, both_sides_get_the_reason_for_closing) {
  open_both();
  server_.connection->close(close_code::kPolicy, "Too many poses.");
  ASSERT_TRUE(run_until([&] { return server_.closed() && client_.closed(); }));
  EXPECT_EQ(client_.handler->closed->code, close_code::kPolicy);
  EXPECT_EQ(client_.handler->closed->sentence, "Too many poses.");
  EXPECT_TRUE(client_.handler->closed->by_peer);
  EXPECT_EQ(server_.handler->closed->code, close_code::kPolicy);
  EXPECT_FALSE(server_.handler->closed->by_peer);
}

TEST_F(WebSocketConnectionEnd, when_both_close_at_once_each_keeps_its_own_reason) {
  open_both();
  server_.connection->close(close_code::kGoingAway, "server");
  client_.connection->close(close_code::kNormal, "client");
  ASSERT_TRUE(run_until([&] { return server_.closed() && client_.closed(); }));
  EXPECT_EQ(server_.handler->closed->sentence, "server");
  EXPECT_EQ(client_.handler->closed->sentence, "client");
}

TEST_F(WebSocketConnectionEnd, the_loop_ends_by_itself_once_all_is_closed) {
  open_both();
  client_.connection->close(close_code::kNormal, "");
  io_.run_for(5s);
  EXPECT_TRUE(io_.stopped());
  EXPECT_TRUE(server_.closed() && client_.closed());
  EXPECT_EQ(client_.handler.use_count(), 1) << "the handler was let go";
}

TEST_F(WebSocketConnectionEnd, close_after_sends_a_last_message) {
  open_both();
  server_.connection->close_after(message_of("why"), close_code::kPolicy, "because");
  ASSERT_TRUE(run_until([&] { return client_.closed(); }));
  EXPECT_THAT(client_.handler->messages, ElementsAre(bytes_of("why")));
}

TEST_F(WebSocketConnectionEnd, closing_before_start_still_says_why) {
  auto sockets = connected_sockets();
  server_.connection = std::make_shared<WebSocketConnection>(Stream(std::move(sockets.ours)),
                                                             options(WebSocketRole::kServer),
                                                             std::span<const std::uint8_t>());
  server_.connection->close_after(message_of("full"), close_code::kTryAgainLater, "full");
  server_.connection->start(server_.handler);
  client_ = open(std::move(sockets.theirs), options(WebSocketRole::kClient));
  ASSERT_TRUE(run_until([&] { return server_.closed() && client_.closed(); }));
  EXPECT_THAT(client_.handler->messages, ElementsAre(bytes_of("full")));
  EXPECT_EQ(client_.handler->closed->code, close_code::kTryAgainLater);
}

TEST_F(WebSocketConnectionEnd, a_handler_may_close_while_it_is_given_a_message) {
  open_both();
  server_.handler->when_message = [&] {
    server_.connection->close(close_code::kPolicy, "no");
    EXPECT_FALSE(server_.closed()) << "never from within a call";
  };
  client_.send(message_of("1"));
  client_.send(message_of("2"));
  ASSERT_TRUE(run_until([&] { return server_.closed() && client_.closed(); }));
  EXPECT_EQ(server_.handler->messages.size(), 1U) << "nothing after close()";
}

TEST_F(WebSocketConnectionEnd, only_the_first_close_counts) {
  open_both();
  client_.connection->close(close_code::kNormal, "first");
  client_.connection->close(close_code::kPolicy, "second");
  client_.connection->wake();
  ASSERT_TRUE(run_until([&] { return server_.closed() && client_.closed(); }));
  client_.connection->close(close_code::kPolicy, "third");
  client_.connection->wake();
  run_ready();
  EXPECT_EQ(server_.handler->closed->sentence, "first");
}

TEST_F(WebSocketConnectionEnd, a_close_without_a_code_is_answered_with_1000) {
  open_server();
  peer_sends(Opcode::kClose);
  EXPECT_THAT(peer_receives(1), ElementsAre("close 1000 "));
  EXPECT_EQ(server_.handler->closed->code, close_code::kNoCode);
}

TEST_F(WebSocketConnectionEnd, closing_is_bounded_when_the_peer_does_not_answer) {
  open_server({.close_within = 50ms});
  server_.connection->close(close_code::kNormal, "bye");
  ASSERT_TRUE(run_until([&] { return server_.closed(); }));
  EXPECT_EQ(server_.handler->closed->sentence, "bye");
  EXPECT_FALSE(server_.handler->closed->by_peer);
}

TEST_F(WebSocketConnectionEnd, closing_is_bounded_when_the_peer_does_not_read) {
  open_server({.close_within = 50ms});
  for (int i = 0; i < 20; ++i) server_.send(frame_message(MessageBuffer(pattern(kTwoMiB))));
  run_ready();
  ASSERT_GT(server_.connection->unwritten_bytes(), 0U);
  server_.connection->close(close_code::kNormal, "bye");
  ASSERT_TRUE(run_until([&] { return server_.closed(); }));
}

TEST_F(WebSocketConnectionEnd, a_violation_is_closed_with_its_code_even_amid_garbage) {
  open_server();
  boost::asio::write(*peer_, boost::asio::buffer(Bytes(300'000, 0xFF)));
  EXPECT_THAT(peer_receives(1),
              ElementsAre("close 1002 A reserved bit is set, but no WebSocket extension was agreed "
                          "on."));
  ASSERT_TRUE(run_until([&] { return server_.closed(); }));
  EXPECT_EQ(server_.handler->closed->code, close_code::kProtocolError);
  EXPECT_FALSE(server_.handler->closed->by_peer);
}

TEST_F(WebSocketConnectionEnd, too_large_and_text_messages_have_their_own_codes) {
  open_server();
  server_.connection->set_max_message_bytes(10);
  peer_sends(Opcode::kBinary, "12345678901");
  EXPECT_THAT(peer_receives(1),
              ElementsAre("close 1009 A message is larger than the limit of 10 bytes."));
  open_server();
  peer_sends(Opcode::kText, "hello");
  EXPECT_THAT(peer_receives(1),
              ElementsAre("close 1003 Text messages are not accepted; send binary ones."));
}

TEST_F(WebSocketConnectionEnd, distinguishes_a_lost_connection_from_a_close) {
  open_server();
  peer_->close();
  ASSERT_TRUE(run_until([&] { return server_.closed(); }));
  EXPECT_EQ(server_.handler->closed->code, close_code::kAbnormal);
  EXPECT_TRUE(server_.handler->closed->by_peer);
}

TEST_F(WebSocketConnectionEnd, messages_sent_before_the_connection_was_lost_are_delivered) {
  open_both();
  // The server sends a reason and disconnects at once, while the client is writing.
  server_.connection->close_after(message_of("why"), close_code::kPolicy, "because");
  for (int i = 0; i < 50; ++i) client_.send(frame_message(MessageBuffer(pattern(100'000))));
  ASSERT_TRUE(run_until([&] { return client_.closed(); }));
  EXPECT_THAT(client_.handler->messages, ElementsAre(bytes_of("why")));
  EXPECT_EQ(client_.handler->closed->code, close_code::kPolicy);
}

TEST_F(WebSocketConnectionEnd, a_silent_peer_is_pinged_and_then_disconnected) {
  open_server({.ping_after = 20ms, .give_up_after = 600ms});
  EXPECT_THAT(peer_receives(1), ElementsAre("ping "));
  ASSERT_TRUE(run_until([&] { return server_.closed(); }));
  EXPECT_EQ(server_.handler->closed->code, close_code::kAbnormal);
  EXPECT_FALSE(server_.handler->closed->by_peer);
}

TEST_F(WebSocketConnectionEnd, timings_can_be_changed_while_it_is_open) {
  open_server({.ping_after = 60s, .give_up_after = 120s});
  server_.connection->set_timings({.ping_after = 10ms, .give_up_after = 60ms});
  ASSERT_TRUE(run_until([&] { return server_.closed(); }));
  EXPECT_EQ(server_.handler->closed->code, close_code::kAbnormal);
}

TEST_F(WebSocketConnectionEnd, a_side_that_could_not_read_does_not_count_that_as_silence) {
  open_server({.ping_after = 150ms, .give_up_after = 300ms});
  run_ready();
  std::this_thread::sleep_for(400ms);
  run_ready();
  EXPECT_FALSE(server_.closed()) << "nothing was asked yet";
  EXPECT_THAT(peer_receives(1), ElementsAre("ping "));
  ASSERT_TRUE(run_until([&] { return server_.closed(); })) << "it is silent all the same";
}

TEST_F(WebSocketConnectionEnd, pings_keep_a_quiet_connection_open) {
  open_both({.ping_after = 10ms, .give_up_after = 200ms});
  const auto standstill = run_for(450ms);
  if (standstill > 100ms) GTEST_SKIP() << "The machine stood still for too long to tell.";
  EXPECT_FALSE(server_.closed());
  EXPECT_FALSE(client_.closed());
  EXPECT_GE(server_.connection->counters().bytes_in, 2U) << "pings and pongs went to and fro";
}

TEST_F(WebSocketConnectionEnd, a_peer_that_neither_reads_nor_writes_is_disconnected) {
  open_server({.ping_after = 20ms, .give_up_after = 60ms});
  for (int i = 0; i < 20; ++i) server_.send(frame_message(MessageBuffer(pattern(kTwoMiB))));
  ASSERT_TRUE(run_until([&] { return server_.closed(); }));
  EXPECT_EQ(server_.handler->closed->code, close_code::kAbnormal);
}

TEST_F(WebSocketConnectionEnd, a_peer_that_only_reads_a_long_message_is_alive) {
  const auto large = frame_message(MessageBuffer(pattern(kTwoMiB)));
  std::vector<char> sink(512 * 1024);
  open_server({.ping_after = 20ms, .give_up_after = 200ms});
  for (int i = 0; i < 100; ++i) server_.handler->to_send.push_back(large);
  server_.connection->wake();
  auto next_read = std::chrono::steady_clock::now();
  const auto standstill = run_for(450ms, [&] {
    if (std::chrono::steady_clock::now() < next_read) return;
    peer_takes(sink);
    next_read += 10ms;
  });
  if (standstill > 100ms) GTEST_SKIP() << "The machine stood still for too long to tell.";
  EXPECT_GT(server_.connection->unwritten_bytes(), 0U) << "it must have been writing all the time";
  EXPECT_FALSE(server_.closed());
}

TEST_F(WebSocketConnectionEnd, the_lease_is_given_back_when_the_socket_closes) {
  auto sockets = connected_sockets();
  auto server_options = options(WebSocketRole::kServer);
  auto lease = std::make_shared<int>();
  const std::weak_ptr<int> watched = lease;
  server_options.lease = std::move(lease);
  server_ = open(std::move(sockets.ours), std::move(server_options));
  EXPECT_FALSE(watched.expired());
  sockets.theirs.close();
  ASSERT_TRUE(run_until([&] { return server_.closed(); }));
  EXPECT_TRUE(watched.expired());
}

}  // namespace
}  // namespace roomcast::net
