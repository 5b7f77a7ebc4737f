// SPDX-License-Identifier: Apache-2.0
// Address of a hub: "ws://host:port/ws", "http://host:port", "host:port", "host", "[::1]:7600";
// with TLS "wss://host:port/ws", "https://host". "wss://host#sha256=<64 hexadecimal digits>" trusts
// only the certificate with this fingerprint, regardless of its signer. The default port is that of
// every https:// and wss:// address, 443; without TLS it is the hub's own, 7600.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/net/tls/fingerprint.h"

namespace roomcast::net {

inline constexpr std::uint16_t kDefaultPort = 7600, kDefaultTlsPort = 443;

struct HubUrl {
  std::string host;  // without the brackets of an IPv6 address
  std::uint16_t port = kDefaultPort;
  std::string path = "/ws";
  bool tls = false;
  std::optional<Fingerprint> pinned = std::nullopt;  // with TLS only

  friend bool operator==(const HubUrl&, const HubUrl&) = default;
};

/// kInvalidArgument: not such an address.
[[nodiscard]] Result<HubUrl> parse_hub_url(std::string_view text);

/// One or more, separated by commas.
[[nodiscard]] Result<std::vector<HubUrl>> parse_hub_urls(std::string_view text);

/// "host:port", "[::1]:port"
[[nodiscard]] std::string host_and_port(const HubUrl& url);
/// "ws://host:port/ws", "wss://host:port/ws#sha256=..."
[[nodiscard]] std::string to_string(const HubUrl& url);

}  // namespace roomcast::net
