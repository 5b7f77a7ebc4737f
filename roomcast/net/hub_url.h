// SPDX-License-Identifier: Apache-2.0
// Where a hub is: "ws://host:port/ws", "http://host:port", "host:port", "host", "[::1]:7600".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "roomcast/core/result.h"

namespace roomcast::net {

inline constexpr std::uint16_t kDefaultPort = 7600;

struct HubUrl {
  std::string host;  // without the brackets of an IPv6 address
  std::uint16_t port = kDefaultPort;
  std::string path = "/ws";
};

/// Errors: kInvalidArgument (not such an address), kUnsupported (wss:// and https://).
[[nodiscard]] Result<HubUrl> parse_hub_url(std::string_view text);

/// "host:port", "[::1]:port"
[[nodiscard]] std::string host_and_port(const HubUrl& url);
/// "ws://host:port/ws"
[[nodiscard]] std::string to_string(const HubUrl& url);

}  // namespace roomcast::net
