// SPDX-License-Identifier: Apache-2.0
// Content Security Policy of a page: it may run only scripts from its server and connect only to
// that server, and, where the server allows it, to the WebSockets of other servers. Only named
// sites may show it in a frame. Source: Content Security Policy Level 3 (W3C). Pure.
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

/// kPagePolicy that also permits connections to these servers' WebSockets, and frames in pages of
/// `embedding_sites` (parse_web_site).
[[nodiscard]] std::string page_policy(std::span<const HubUrl> others,
                                      std::span<const std::string> embedding_sites = {});

/// The Origin of the server's pages, as browsers write it: "https://b.example.org:7600".
[[nodiscard]] std::string site_of(const HubUrl& server);

}  // namespace roomcast::net
