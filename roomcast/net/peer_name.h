// SPDX-License-Identifier: Apache-2.0
// The identity of a peer for counting and banning: an IPv4 address, or the 64-bit network prefix of
// an IPv6 address, because one machine may use all addresses of its prefix. Threading: no state.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>

namespace roomcast::net {

/// "192.0.2.7", also if it is mapped into IPv6; "2001:db8:1:2::/64"; "::1".
[[nodiscard]] std::string peer_name(const boost::asio::ip::address& address);

/// The peer name of a numeric address; a peer name is returned unchanged. Nothing: it is neither.
[[nodiscard]] std::optional<std::string> parse_peer_name(std::string_view text);

/// Of a connected socket; empty if it is disconnected.
[[nodiscard]] std::string peer_name(const boost::asio::ip::tcp::socket& socket);

}  // namespace roomcast::net
