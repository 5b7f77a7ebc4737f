// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/peer_name.h"

#include <algorithm>

namespace roomcast::net {

namespace ip = boost::asio::ip;

std::string peer_name(const ip::address& address) {
  if (address.is_v4() || address.is_loopback()) return address.to_string();
  const ip::address_v6 v6 = address.to_v6();
  if (v6.is_v4_mapped()) return ip::make_address_v4(ip::v4_mapped, v6).to_string();
  auto bytes = v6.to_bytes();
  std::fill(bytes.begin() + 8, bytes.end(), 0);
  return ip::address_v6(bytes).to_string() + "/64";
}

std::optional<std::string> parse_peer_name(std::string_view text) {
  constexpr std::string_view kNetwork = "/64";
  const bool is_network = text.ends_with(kNetwork);
  if (is_network) text.remove_suffix(kNetwork.size());
  boost::system::error_code not_numeric;
  const auto address = ip::make_address(text, not_numeric);
  if (not_numeric || (is_network && address.is_v4())) return std::nullopt;
  return peer_name(address);
}

std::string peer_name(const ip::tcp::socket& socket) {
  boost::system::error_code gone;
  const auto endpoint = socket.remote_endpoint(gone);
  return gone ? std::string() : peer_name(endpoint.address());
}

}  // namespace roomcast::net
