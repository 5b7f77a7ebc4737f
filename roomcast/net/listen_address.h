// SPDX-License-Identifier: Apache-2.0
// The address on which a hub listens: "127.0.0.1:7600", "[::1]:0", "0.0.0.0:7600".
#pragma once

#include <cstdint>
#include <string>

#include "roomcast/core/result.h"

namespace roomcast::net {

struct ListenAddress {
  std::string address;
  std::uint16_t port = 0;
  bool loopback = false;  // reachable from this machine only
};

/// kInvalidArgument with the reason.
[[nodiscard]] Result<ListenAddress> parse_listen_address(const std::string& text);

}  // namespace roomcast::net
