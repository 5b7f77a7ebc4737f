// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/allowed_names.h"

#include <algorithm>

#include <boost/asio/ip/address.hpp>
#include <boost/beast/core/string.hpp>

#include "roomcast/net/websocket_handshake.h"

namespace roomcast::net {

namespace {

bool same_text(std::string_view a, std::string_view b) {
  return boost::beast::iequals({a.data(), a.size()}, {b.data(), b.size()});
}

/// "[::1]:7600" -> "::1", "hub:7600" -> "hub"
std::string_view without_port(std::string_view host) {
  if (host.starts_with('[')) return host.substr(1, host.find(']') - 1);
  return host.substr(0, host.find(':'));
}

bool is_numeric(std::string_view host) {
  boost::system::error_code no_address;
  boost::asio::ip::make_address(std::string(host), no_address);
  return !no_address;
}

}  // namespace

bool AllowedNames::allows_host(std::string_view host) const {
  if (any_host) return true;
  const std::string_view name = without_port(host);
  if (is_numeric(name) || same_text(name, "localhost")) return true;
  return std::ranges::any_of(hosts, [&](const auto& known) { return same_text(known, name); });
}

bool AllowedNames::allows_origin(std::string_view origin, std::string_view host) const {
  if (is_same_host(origin, host)) return true;
  return std::ranges::any_of(origins, [&](const auto& known) { return same_text(known, origin); });
}

}  // namespace roomcast::net
