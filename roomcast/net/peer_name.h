// SPDX-License-Identifier: Apache-2.0
// Who a connection comes from, for counting and banning: an IPv4 address; of an IPv6 address the
// 64 bits that its network has, because one machine may use all the rest. Threading: no state.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>

namespace roomcast::net {

/// "192.0.2.7", also when it comes mapped into IPv6; "2001:db8:1:2::/64"; "::1".
[[nodiscard]] std::string peer_name(const boost::asio::ip::address& address);

/// Who comes from this address, which is written as a number; such a name names itself. Nothing: it
/// is neither.
[[nodiscard]] std::optional<std::string> parse_peer_name(std::string_view text);

/// Of a connected socket; empty when it has gone.
[[nodiscard]] std::string peer_name(const boost::asio::ip::tcp::socket& socket);

}  // namespace roomcast::net
