// SPDX-License-Identifier: Apache-2.0
// The addresses by which other machines reach this one, for who has to type one. Threading: no
// state.
#pragma once

#include <string>
#include <vector>

namespace roomcast::net {

/// The numeric addresses of the network interfaces that are up, without loopback and link-local
/// ones; IPv6 only if asked for. Behind NAT there are others, which no program here knows.
[[nodiscard]] std::vector<std::string> own_addresses(bool with_ipv6);

}  // namespace roomcast::net
