// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/socket_tuning.h"

#include <vector>

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include "roomcast/net/loopback_fixture.h"

namespace roomcast::net {
namespace {

class SocketTuningTest : public LoopbackTest {
 protected:
  static int option(Tcp::socket& socket, int name) {
    int value = 0;
    socklen_t size = sizeof(value);
    EXPECT_EQ(::getsockopt(socket.native_handle(), IPPROTO_TCP, name, &value, &size), 0);
    return value;
  }
};

TEST_F(SocketTuningTest, sets_the_options_of_live_streams) {
  auto sockets = connected_sockets();
  tune_for_live_streams(sockets.ours);
  EXPECT_TRUE(sockets.ours.non_blocking());
  EXPECT_EQ(option(sockets.ours, TCP_NODELAY), 1);
  EXPECT_EQ(option(sockets.ours, TCP_NOTSENT_LOWAT), kMaxUnsentBytes);
}

TEST_F(SocketTuningTest, a_closed_socket_is_left_alone) {
  Tcp::socket closed(io_);
  tune_for_live_streams(closed);
  EXPECT_FALSE(closed.is_open());
}

TEST_F(SocketTuningTest, a_socket_is_writable_until_the_peer_stops_reading) {
  auto sockets = connected_sockets();
  tune_for_live_streams(sockets.ours);
  EXPECT_TRUE(is_writable_now(sockets.ours));
  const std::vector<char> bytes(1 << 20);
  boost::system::error_code error;
  while (!error) sockets.ours.write_some(boost::asio::buffer(bytes), error);
  EXPECT_EQ(error, boost::asio::error::would_block);
  EXPECT_FALSE(is_writable_now(sockets.ours));
}

}  // namespace
}  // namespace roomcast::net
