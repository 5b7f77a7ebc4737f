// SPDX-License-Identifier: Apache-2.0
// AllowedNames: the host names under which a server answers, and the origins of other sites whose
// pages may connect. Protects against DNS rebinding: a foreign site can later make its
// name resolve to this machine; the browser then connects here, but still sends the foreign name.
// Names are therefore checked; numeric addresses cannot be rebound. Threading: immutable.
// Source: RFC 9110 section 7.2 (Host), RFC 6454 (Origin).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace roomcast::net {

struct AllowedNames {
  bool any_host = false;                  // set with TLS only: the certificate proves the name
  std::vector<std::string> hosts = {};    // plus numeric addresses and "localhost"; without port
  std::vector<std::string> origins = {};  // "https://rooms.example.org", plus the server's own

  /// Checks a Host header.
  [[nodiscard]] bool allows_host(std::string_view host) const;
  /// Checks an Origin header of a request to `host`.
  [[nodiscard]] bool allows_origin(std::string_view origin, std::string_view host) const;
};

}  // namespace roomcast::net
