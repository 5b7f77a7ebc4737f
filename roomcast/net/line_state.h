// SPDX-License-Identifier: Apache-2.0
// What the kernel knows of a TCP connection's line: how much has arrived at the peer, how much
// still waits, and how fast and how far the way is. Source: tcp_info and tcp_bbr_info of Linux.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace roomcast::net {

struct LineState {
  std::uint64_t delivered_bytes = 0;  // that the peer's TCP has, since the connection began
  std::uint64_t unsent_bytes = 0;     // that the kernel has accepted, and not sent yet
  std::chrono::microseconds round_trip{};
  std::uint64_t resent_packets = 0;  // since the connection began
  /// BBR's estimate of the bandwidth; 0: none, or another congestion control.
  double bbr_bytes_per_s = 0;
  /// BBR drains the line for a moment, to measure the round trip; little is sent meanwhile.
  bool is_probing_round_trip = false;
};

/// Nothing: this is no connected TCP socket.
[[nodiscard]] std::optional<LineState> line_state(int socket);

}  // namespace roomcast::net
