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

TEST_F(SocketTuningTest, retransmission_timers_are_early_where_the_kernel_offers_it) {
  constexpr int kRetransmissionMinUs = 45;  // TCP_RTO_MIN_US of Linux 6.15
  auto sockets = connected_sockets();
  int before_us = 0;
  socklen_t size = sizeof(before_us);
  if (::getsockopt(sockets.ours.native_handle(), IPPROTO_TCP, kRetransmissionMinUs, &before_us,
                   &size) != 0)
    GTEST_SKIP() << "this kernel does not";
  tune_for_live_streams(sockets.ours);
  EXPECT_LT(option(sockets.ours, kRetransmissionMinUs), 80'000);
  EXPECT_EQ(option(sockets.ours, TCP_THIN_LINEAR_TIMEOUTS), 1);
}

TEST_F(SocketTuningTest, segments_of_a_slow_line_are_small_and_its_headers_are_counted) {
  const Pace slow = pace_for(12'500), usual = pace_for(60'000), fast = pace_for(2'500'000);
  EXPECT_EQ(slow.segment_bytes, 536);
  EXPECT_EQ(usual.segment_bytes, 1'000);
  EXPECT_EQ(fast.segment_bytes, 1'448);
  for (const Pace& pace : {slow, usual, fast})
    EXPECT_GT(pace.payload_bytes_per_s, 536 / 588.0 * 12'500 - 1);
  EXPECT_NEAR(usual.payload_bytes_per_s * (1'000 + 52) / 1'000, 60'000, 1);
}

TEST_F(SocketTuningTest, the_kernel_paces_what_a_socket_sends) {
  auto sockets = connected_sockets();
  set_pace(sockets.ours, 20'000);
  std::uint32_t pace = 0;
  socklen_t size = sizeof(pace);
  ASSERT_EQ(
      ::getsockopt(sockets.ours.native_handle(), SOL_SOCKET, SO_MAX_PACING_RATE, &pace, &size), 0);
  EXPECT_EQ(pace, 20'000u);
}

TEST_F(SocketTuningTest, segments_are_limited_before_connecting) {
  auto acceptor = Tcp::acceptor(io_, {boost::asio::ip::address_v4::loopback(), 0});
  Tcp::socket socket(io_);
  socket.open(Tcp::v4());
  limit_segments(socket, 536);
  socket.connect(acceptor.local_endpoint());
  const Tcp::socket peer = acceptor.accept();
  tcp_info info{};
  socklen_t size = sizeof(info);
  ASSERT_EQ(::getsockopt(socket.native_handle(), IPPROTO_TCP, TCP_INFO, &info, &size), 0);
  EXPECT_EQ(info.tcpi_snd_mss, 536u);
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
