// SPDX-License-Identifier: Apache-2.0
// Compiled by itself: linux/tcp.h and netinet/tcp.h, which Asio includes, do not go together.
#include "roomcast/net/line_state.h"

#include <string_view>

#include <linux/inet_diag.h>
#include <linux/tcp.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace roomcast::net {
namespace {

constexpr std::string_view kBbr = "bbr";
constexpr std::uint32_t kUnitGain = 256;  // BBR's 1.0; as gain of the window only in that phase

bool uses_bbr(int socket) {
  char name[16] = {};  // TCP_CA_NAME_MAX
  socklen_t size = sizeof(name);
  if (::getsockopt(socket, IPPROTO_TCP, TCP_CONGESTION, name, &size) != 0) return false;
  return std::string_view(name).starts_with(kBbr);
}

void add_bbr(int socket, LineState& state) {
  tcp_cc_info info{};
  socklen_t size = sizeof(info);
  if (!uses_bbr(socket) || ::getsockopt(socket, IPPROTO_TCP, TCP_CC_INFO, &info, &size) != 0 ||
      size < sizeof(info.bbr)) {
    return;
  }
  const auto high = static_cast<std::uint64_t>(info.bbr.bbr_bw_hi);
  state.bbr_bytes_per_s = static_cast<double>(high << 32 | info.bbr.bbr_bw_lo);
  state.is_probing_round_trip = info.bbr.bbr_cwnd_gain == kUnitGain;
}

}  // namespace

std::optional<LineState> line_state(int socket) {
  tcp_info info{};
  socklen_t size = sizeof(info);
  if (::getsockopt(socket, IPPROTO_TCP, TCP_INFO, &info, &size) != 0) return std::nullopt;
  LineState state;
  state.delivered_bytes =
      info.tcpi_bytes_acked + static_cast<std::uint64_t>(info.tcpi_sacked) * info.tcpi_snd_mss;
  state.unsent_bytes = info.tcpi_notsent_bytes;
  state.round_trip = std::chrono::microseconds(info.tcpi_rtt);
  state.resent_packets = info.tcpi_total_retrans;
  add_bbr(socket, state);
  return state;
}

}  // namespace roomcast::net
