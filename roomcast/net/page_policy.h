// SPDX-License-Identifier: Apache-2.0
// What a page may do in a browser: nothing but run what its server sent, and ask that one; and,
// where a server says so, connect to the WebSockets of servers beside it. Source: Content Security
// Policy Level 3 (W3C). Pure.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "roomcast/net/hub_url.h"

namespace roomcast::net {

inline constexpr std::string_view kPagePolicy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; "
    "connect-src 'self'; img-src 'self' data:; style-src 'self'; base-uri 'none'; "
    "form-action 'self'; frame-ancestors 'none'";

/// kPagePolicy, and it may connect to these servers' WebSockets, too.
[[nodiscard]] std::string page_policy(std::span<const HubUrl> others);

/// The server's pages' Origin, as browsers write it: "https://b.example.org:7600".
[[nodiscard]] std::string site_of(const HubUrl& server);

}  // namespace roomcast::net
