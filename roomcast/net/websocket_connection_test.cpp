// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/websocket_connection.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/net/loopback_fixture.h"
#include "roomcast/net/websocket_reader.h"

namespace roomcast::net {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kTwoMiB = std::size_t{2} << 20;

Bytes bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

Bytes pattern(std::size_t size) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i * 31 + (i >> 9));
  return bytes;
}

class WebSocketConnectionTest : public LoopbackTest {
 protected:
  struct End {
    std::shared_ptr<WebSocketConnection> connection;
    std::shared_ptr<RecordingHandler> handler = std::make_shared<RecordingHandler>();

    void send(SealedMessagePtr message) {
      handler->to_send.push_back(std::move(message));
      connection->wake();
    }
    [[nodiscard]] bool closed() const { return handler->closed.has_value(); }
  };

  static ConnectionOptions options(WebSocketRole role, ConnectionTimings timings = {}) {
    ConnectionOptions options;
    options.role = role;
    options.max_message_bytes = kTwoMiB;
    options.timings = timings;
    return options;
  }

  End open(Tcp::socket socket, ConnectionOptions options,
           std::span<const std::uint8_t> received = {}) {
    End end;
    end.connection =
        std::make_shared<WebSocketConnection>(std::move(socket), std::move(options), received);
    end.connection->start(end.handler);
    return end;
  }

  /// Both ends are ours.
  void open_both(ConnectionTimings timings = {}) {
    auto sockets = connected_sockets();
    server_ = open(std::move(sockets.ours), options(WebSocketRole::kServer, timings));
    client_ = open(std::move(sockets.theirs), options(WebSocketRole::kClient, timings));
  }

  /// The server is ours, the test plays the client byte by byte.
  void open_server(ConnectionTimings timings = {}) {
    auto sockets = connected_sockets();
    server_ = open(std::move(sockets.ours), options(WebSocketRole::kServer, timings));
    peer_.emplace(std::move(sockets.theirs));
  }

  void peer_sends(Opcode opcode, std::string_view payload = "") {
    const auto frame = seal(MessageBuffer(bytes_of(payload)), opcode, MaskKey{1, 2, 3, 4});
    boost::asio::write(*peer_,
                       boost::asio::buffer(frame->wire_bytes().data(), frame->wire_bytes().size()));
  }

  /// Reads what is there, at most a bufferful.
  void peer_takes(std::vector<char>& buffer) {
    boost::system::error_code nothing_there;
    peer_->non_blocking(true);
    peer_->read_some(boost::asio::buffer(buffer), nothing_there);
  }

  /// Frames that the peer has received, until the server ends or `count` came.
  std::vector<std::string> peer_receives(std::size_t count) {
    WebSocketReader reader(WebSocketRole::kClient, 4 * kTwoMiB);
    std::vector<std::string> events;
    std::size_t used = 0;
    receive(*peer_, [&](const std::string& all) {
      std::span<const std::uint8_t> rest(reinterpret_cast<const std::uint8_t*>(all.data()) + used,
                                         all.size() - used);
      for (;;) {
        const ReaderEvent event = reader.next(rest);
        if (std::holds_alternative<NeedsMoreBytes>(event)) break;
        events.push_back(name(event));
      }
      used = all.size();
      return events.size() >= count;
    });
    return events;
  }

  static std::string name(const ReaderEvent& event) {
    if (const auto* message = std::get_if<MessageBuffer>(&event)) {
      return "message of " + std::to_string(message->size());
    }
    if (const auto* ping = std::get_if<Ping>(&event)) return "ping " + ping->payload;
    if (const auto* pong = std::get_if<Pong>(&event)) return "pong " + pong->payload;
    if (const auto* close = std::get_if<PeerClose>(&event)) {
      return "close " + std::to_string(close->code) + " " + close->reason;
    }
    return "violation";
  }

  End server_;
  End client_;
  std::optional<Tcp::socket> peer_;
};

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

TEST_F(WebSocketConnectionTest, carries_messages_of_two_mebibytes_unharmed) {
  open_both();
  const Bytes payload = pattern(kTwoMiB);
  client_.send(seal(MessageBuffer(payload)));
  server_.send(seal(MessageBuffer(payload)));
  ASSERT_TRUE(run_until(
      [&] { return !server_.handler->messages.empty() && !client_.handler->messages.empty(); }));
  EXPECT_EQ(server_.handler->messages[0], payload);
  EXPECT_EQ(client_.handler->messages[0], payload);
}

TEST_F(WebSocketConnectionTest, one_sealed_message_goes_to_many_without_a_copy) {
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

TEST_F(WebSocketConnectionTest, a_peer_that_does_not_read_stops_the_asking_not_the_program) {
  open_server();
  const auto large = seal(MessageBuffer(pattern(64 * 1024)));
  constexpr int kOffered = 1000;  // 64 MB: more than any socket buffer takes
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

TEST_F(WebSocketConnectionTest, a_congested_socket_is_offered_one_message_at_a_time) {
  open_server();
  const auto small = seal(MessageBuffer(pattern(1000)));
  for (int i = 0; i < 60'000; ++i) server_.handler->to_send.push_back(small);
  server_.connection->wake();
  int given_before = -1;
  ASSERT_TRUE(run_until([&] {
    run_ready();
    return std::exchange(given_before, server_.handler->times_given) ==
           server_.handler->times_given;
  }));
  // From now on it writes what the peer makes room for.
  std::vector<char> sink(1 << 20);
  std::size_t highest = 0;
  for (int i = 0; i < 20; ++i) {
    peer_takes(sink);
    run_ready();
    if (i > 2) highest = std::max(highest, server_.connection->unwritten_bytes());
  }
  EXPECT_LE(highest, 64U * 1024) << "what waits, waits with the handler";
}

TEST_F(WebSocketConnectionTest, a_pong_waits_for_the_end_of_the_message_being_written) {
  open_server();
  server_.send(seal(MessageBuffer(pattern(kTwoMiB))));
  run_ready();
  ASSERT_GT(server_.connection->unwritten_bytes(), 0U) << "the message must still be on its way";
  peer_sends(Opcode::kPing, "now?");
  run_ready();
  EXPECT_THAT(peer_receives(2), ElementsAre("message of " + std::to_string(kTwoMiB), "pong now?"));
}

TEST_F(WebSocketConnectionTest, many_pings_of_a_peer_that_does_not_read_cost_one_pong) {
  open_server();
  server_.send(seal(MessageBuffer(pattern(kTwoMiB))));
  run_ready();
  ASSERT_GT(server_.connection->unwritten_bytes(), 0U);
  const std::size_t before = server_.connection->unwritten_bytes();
  for (int i = 0; i < 1000; ++i) peer_sends(Opcode::kPing, std::to_string(i));
  run_ready();
  EXPECT_LE(server_.connection->unwritten_bytes(), before);
  EXPECT_THAT(peer_receives(2), ElementsAre("message of " + std::to_string(kTwoMiB), "pong 999"));
}

TEST_F(WebSocketConnectionTest, both_sides_learn_why_one_closed) {
  open_both();
  server_.connection->close(close_code::kPolicy, "Too many poses.");
  ASSERT_TRUE(run_until([&] { return server_.closed() && client_.closed(); }));
  EXPECT_EQ(client_.handler->closed->code, close_code::kPolicy);
  EXPECT_EQ(client_.handler->closed->sentence, "Too many poses.");
  EXPECT_TRUE(client_.handler->closed->by_peer);
  EXPECT_EQ(server_.handler->closed->code, close_code::kPolicy);
  EXPECT_FALSE(server_.handler->closed->by_peer);
}

TEST_F(WebSocketConnectionTest, when_both_close_at_once_each_keeps_its_own_reason) {
  open_both();
  server_.connection->close(close_code::kGoingAway, "server");
  client_.connection->close(close_code::kNormal, "client");
  ASSERT_TRUE(run_until([&] { return server_.closed() && client_.closed(); }));
  EXPECT_EQ(server_.handler->closed->sentence, "server");
  EXPECT_EQ(client_.handler->closed->sentence, "client");
}

TEST_F(WebSocketConnectionTest, the_loop_ends_by_itself_once_all_is_closed) {
  open_both();
  client_.connection->close(close_code::kNormal, "");
  io_.run_for(5s);
  EXPECT_TRUE(io_.stopped());
  EXPECT_TRUE(server_.closed() && client_.closed());
  EXPECT_EQ(client_.handler.use_count(), 1) << "the handler was let go";
}

TEST_F(WebSocketConnectionTest, close_after_sends_a_last_message) {
  open_both();
  server_.connection->close_after(message_of("why"), close_code::kPolicy, "because");
  ASSERT_TRUE(run_until([&] { return client_.closed(); }));
  EXPECT_THAT(client_.handler->messages, ElementsAre(bytes_of("why")));
}

TEST_F(WebSocketConnectionTest, closing_before_start_still_says_why) {
  auto sockets = connected_sockets();
  server_.connection = std::make_shared<WebSocketConnection>(
      std::move(sockets.ours), options(WebSocketRole::kServer), std::span<const std::uint8_t>());
  server_.connection->close_after(message_of("full"), close_code::kTryAgainLater, "full");
  server_.connection->start(server_.handler);
  client_ = open(std::move(sockets.theirs), options(WebSocketRole::kClient));
  ASSERT_TRUE(run_until([&] { return server_.closed() && client_.closed(); }));
  EXPECT_THAT(client_.handler->messages, ElementsAre(bytes_of("full")));
  EXPECT_EQ(client_.handler->closed->code, close_code::kTryAgainLater);
}

TEST_F(WebSocketConnectionTest, a_handler_may_close_while_it_is_given_a_message) {
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

TEST_F(WebSocketConnectionTest, only_the_first_close_counts) {
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

TEST_F(WebSocketConnectionTest, a_close_without_a_code_is_answered_with_1000) {
  open_server();
  peer_sends(Opcode::kClose);
  EXPECT_THAT(peer_receives(1), ElementsAre("close 1000 "));
  EXPECT_EQ(server_.handler->closed->code, close_code::kNoCode);
}

TEST_F(WebSocketConnectionTest, closing_is_bounded_when_the_peer_does_not_answer) {
  open_server({.close_within = 50ms});
  server_.connection->close(close_code::kNormal, "bye");
  ASSERT_TRUE(run_until([&] { return server_.closed(); }));
  EXPECT_EQ(server_.handler->closed->sentence, "bye");
  EXPECT_FALSE(server_.handler->closed->by_peer);
}

TEST_F(WebSocketConnectionTest, closing_is_bounded_when_the_peer_does_not_read) {
  open_server({.close_within = 50ms});
  for (int i = 0; i < 20; ++i) server_.send(seal(MessageBuffer(pattern(kTwoMiB))));
  run_ready();
  ASSERT_GT(server_.connection->unwritten_bytes(), 0U);
  server_.connection->close(close_code::kNormal, "bye");
  ASSERT_TRUE(run_until([&] { return server_.closed(); }));
}

TEST_F(WebSocketConnectionTest, a_violation_is_closed_with_its_code_even_amid_garbage) {
  open_server();
  boost::asio::write(*peer_, boost::asio::buffer(Bytes(300'000, 0xFF)));
  EXPECT_THAT(peer_receives(1),
              ElementsAre("close 1002 A reserved bit is set, but no WebSocket extension was agreed "
                          "on."));
  ASSERT_TRUE(run_until([&] { return server_.closed(); }));
  EXPECT_EQ(server_.handler->closed->code, close_code::kProtocolError);
  EXPECT_FALSE(server_.handler->closed->by_peer);
}

TEST_F(WebSocketConnectionTest, too_large_and_text_messages_have_their_own_codes) {
  open_server();
  server_.connection->set_max_message_bytes(10);
  peer_sends(Opcode::kBinary, "12345678901");
  EXPECT_THAT(peer_receives(1),
              ElementsAre("close 1009 A message is larger than the limit of 10 bytes."));
  open_server();
  peer_sends(Opcode::kText, "hello");
  EXPECT_THAT(peer_receives(1),
              ElementsAre("close 1003 Text messages are not understood here; send binary ones."));
}

TEST_F(WebSocketConnectionTest, a_lost_connection_is_told_apart_from_a_goodbye) {
  open_server();
  peer_->close();
  ASSERT_TRUE(run_until([&] { return server_.closed(); }));
  EXPECT_EQ(server_.handler->closed->code, close_code::kAbnormal);
  EXPECT_TRUE(server_.handler->closed->by_peer);
}

TEST_F(WebSocketConnectionTest, what_the_peer_said_before_it_vanished_is_still_heard) {
  open_both();
  // The server says why and cuts the line at once; the client is just writing when that happens.
  server_.connection->close_after(message_of("why"), close_code::kPolicy, "because");
  for (int i = 0; i < 50; ++i) client_.send(seal(MessageBuffer(pattern(100'000))));
  ASSERT_TRUE(run_until([&] { return client_.closed(); }));
  EXPECT_THAT(client_.handler->messages, ElementsAre(bytes_of("why")));
  EXPECT_EQ(client_.handler->closed->code, close_code::kPolicy);
}

TEST_F(WebSocketConnectionTest, silence_is_asked_about_and_then_ended) {
  open_server({.ping_after = 20ms, .give_up_after = 60ms});
  EXPECT_THAT(peer_receives(1), ElementsAre("ping "));
  ASSERT_TRUE(run_until([&] { return server_.closed(); }));
  EXPECT_EQ(server_.handler->closed->code, close_code::kAbnormal);
  EXPECT_FALSE(server_.handler->closed->by_peer);
}

TEST_F(WebSocketConnectionTest, two_quiet_ends_keep_each_other_open) {
  open_both({.ping_after = 10ms, .give_up_after = 200ms});
  const auto standstill = run_for(450ms);
  if (standstill > 100ms) GTEST_SKIP() << "The machine stood still for too long to tell.";
  EXPECT_FALSE(server_.closed());
  EXPECT_FALSE(client_.closed());
  EXPECT_GE(server_.connection->counters().bytes_in, 2U) << "pings and pongs went to and fro";
}

TEST_F(WebSocketConnectionTest, a_peer_that_takes_nothing_and_says_nothing_is_ended) {
  open_server({.ping_after = 20ms, .give_up_after = 60ms});
  for (int i = 0; i < 20; ++i) server_.send(seal(MessageBuffer(pattern(kTwoMiB))));
  ASSERT_TRUE(run_until([&] { return server_.closed(); }));
  EXPECT_EQ(server_.handler->closed->code, close_code::kAbnormal);
}

TEST_F(WebSocketConnectionTest, a_peer_that_only_reads_a_long_message_is_alive) {
  const auto large = seal(MessageBuffer(pattern(kTwoMiB)));
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

TEST_F(WebSocketConnectionTest, the_lease_is_given_back_when_the_socket_closes) {
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

TEST_F(WebSocketConnectionTest, knows_its_peers_address) {
  open_server();
  EXPECT_EQ(server_.connection->peer_address(),
            "127.0.0.1:" + std::to_string(peer_->local_endpoint().port()));
}

}  // namespace
}  // namespace roomcast::net
