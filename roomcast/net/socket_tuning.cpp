// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/socket_tuning.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

namespace roomcast::net {

namespace {

constexpr double kMinSegment = 536, kMaxSegment = 1448;
constexpr double kHeaders = 20 + 20 + 12;  // IPv4, TCP, TCP's time stamps

// Of Linux since 6.15; headers of libraries do not name them yet.
constexpr int kRetransmissionMaxMs = 44;  // TCP_RTO_MAX_MS
constexpr int kRetransmissionMinUs = 45;  // TCP_RTO_MIN_US

/// A burst of losses that takes a retransmission, too, ends in the retransmission timer: by default
/// at least 200 ms beyond the round trip, twice that after the next loss, and so on. A frame is old
/// by then.
void retransmit_soon(int fd) {
  constexpr int kMinWait_us = 60'000;  // more than peers delay an acknowledgement: 40 ms at most
  constexpr int kMaxWait_ms = 2'000;   // 15 of them are longer than a silent peer is waited for
  constexpr int kIsLinear = 1;         // while few segments are under way
  (void)::setsockopt(fd, IPPROTO_TCP, kRetransmissionMinUs, &kMinWait_us, sizeof(kMinWait_us));
  (void)::setsockopt(fd, IPPROTO_TCP, kRetransmissionMaxMs, &kMaxWait_ms, sizeof(kMaxWait_ms));
  (void)::setsockopt(fd, IPPROTO_TCP, TCP_THIN_LINEAR_TIMEOUTS, &kIsLinear, sizeof(kIsLinear));
}

}  // namespace

void tune_for_live_streams(boost::asio::ip::tcp::socket& socket) {
  boost::system::error_code ignored;
  socket.non_blocking(true, ignored);
  socket.set_option(boost::asio::ip::tcp::no_delay(true), ignored);
  const int fd = socket.native_handle();
  const int unsent = kMaxUnsentBytes;
  (void)::setsockopt(fd, IPPROTO_TCP, TCP_NOTSENT_LOWAT, &unsent, sizeof(unsent));
  constexpr std::string_view kCongestionControl = "bbr";
  (void)::setsockopt(fd, IPPROTO_TCP, TCP_CONGESTION, kCongestionControl.data(),
                     static_cast<socklen_t>(kCongestionControl.size()));
  retransmit_soon(fd);
}

Pace pace_for(double line_bytes_per_s) {
  constexpr double kSegmentsPerSecond = 60;
  const double segment =
      std::clamp(line_bytes_per_s / kSegmentsPerSecond, kMinSegment, kMaxSegment);
  return {static_cast<int>(segment), line_bytes_per_s * segment / (segment + kHeaders)};
}

double line_mbit_per_s(double payload_bytes_per_s) {
  return payload_bytes_per_s * (kMaxSegment + kHeaders) / kMaxSegment * 8e-6;
}

void limit_segments(boost::asio::ip::tcp::socket& socket, int segment_bytes) {
  constexpr int kTimeStamps = 12;  // TCP_MAXSEG counts them
  const int bytes = segment_bytes + kTimeStamps;
  (void)::setsockopt(socket.native_handle(), IPPROTO_TCP, TCP_MAXSEG, &bytes, sizeof(bytes));
}

void set_pace(boost::asio::ip::tcp::socket& socket, double payload_bytes_per_s) {
  const auto pace = static_cast<std::uint32_t>(std::clamp(payload_bytes_per_s, 1'000.0, 4e9));
  (void)::setsockopt(socket.native_handle(), SOL_SOCKET, SO_MAX_PACING_RATE, &pace, sizeof(pace));
}

bool is_writable_now(boost::asio::ip::tcp::socket& socket) {
  pollfd question{};
  question.fd = socket.native_handle();
  question.events = POLLOUT;
  return ::poll(&question, 1, 0) > 0;
}

}  // namespace roomcast::net
