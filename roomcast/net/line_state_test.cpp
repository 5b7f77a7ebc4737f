// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/line_state.h"

#include <chrono>
#include <thread>
#include <vector>

#include <boost/asio/read.hpp>

#include "roomcast/net/loopback_fixture.h"
#include "roomcast/net/socket_tuning.h"

namespace roomcast::net {
namespace {

class LineStateTest : public LoopbackTest {};

TEST_F(LineStateTest, counts_what_the_peer_has) {
  auto sockets = connected_sockets();
  const std::vector<char> bytes(5'000);
  boost::asio::write(sockets.ours, boost::asio::buffer(bytes));
  std::vector<char> received(bytes.size());
  boost::asio::read(sockets.theirs, boost::asio::buffer(received));
  std::optional<LineState> state;
  for (int i = 0; i < 200 && (!state || state->delivered_bytes < bytes.size()); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    state = line_state(sockets.ours.native_handle());
  }
  ASSERT_TRUE(state);
  EXPECT_GE(state->delivered_bytes, bytes.size());
  EXPECT_LE(state->delivered_bytes, bytes.size() + 1) << "the handshake counts as a byte";
  EXPECT_EQ(state->unsent_bytes, 0);
  EXPECT_GT(state->round_trip.count(), 0);
}

TEST_F(LineStateTest, knows_what_waits_for_a_peer_that_does_not_read) {
  auto sockets = connected_sockets();
  tune_for_live_streams(sockets.ours);
  const std::vector<char> bytes(1 << 20);
  boost::system::error_code error;
  for (int i = 0; i < 1'000 && !error; ++i)
    sockets.ours.write_some(boost::asio::buffer(bytes), error);
  ASSERT_EQ(error, boost::asio::error::would_block);
  const auto state = line_state(sockets.ours.native_handle());
  ASSERT_TRUE(state);
  EXPECT_GT(state->unsent_bytes, 0);
}

TEST_F(LineStateTest, there_is_none_without_a_connection) {
  EXPECT_FALSE(line_state(-1));
}

}  // namespace
}  // namespace roomcast::net
