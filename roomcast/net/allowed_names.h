// SPDX-License-Identifier: Apache-2.0
// AllowedNames: under which names a server answers, and pages of which other sites may connect.
// A page of somebody else's site can have its name point to this machine afterwards (DNS
// rebinding); the browser then takes the server for that site, but still says its name. So names
// are checked; numeric addresses cannot be rebound. Threading: immutable.
// Source: RFC 9110 section 7.2 (Host), RFC 6454 (Origin).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace roomcast::net {

struct AllowedNames {
  bool any_host = true;                   // with TLS the certificate proves the name
  std::vector<std::string> hosts = {};    // besides numeric addresses and "localhost"; without port
  std::vector<std::string> origins = {};  // "https://rooms.example.org", besides the server's own

  /// Of a Host header.
  [[nodiscard]] bool allows_host(std::string_view host) const;
  /// Of an Origin header, for a request to `host`.
  [[nodiscard]] bool allows_origin(std::string_view origin, std::string_view host) const;
};

}  // namespace roomcast::net
