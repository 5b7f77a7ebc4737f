// SPDX-License-Identifier: Apache-2.0
// The rules of the WebSocket handshake, on parsed HTTP headers; no sockets.
// Source: RFC 6455 sections 4.1 (client) and 4.2 (server); docs/spec/wire.md section 1 for Origin.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/fields.hpp>
#include <boost/beast/http/message.hpp>

#include "roomcast/net/allowed_names.h"
#include "roomcast/net/http_response.h"

namespace roomcast::net {

using RequestHeader = boost::beast::http::header<true, boost::beast::http::fields>;
using ResponseHeader = boost::beast::http::header<false, boost::beast::http::fields>;
using EmptyRequest = boost::beast::http::request<boost::beast::http::empty_body>;
using EmptyResponse = boost::beast::http::response<boost::beast::http::empty_body>;

/// Sec-WebSocket-Accept for this Sec-WebSocket-Key.
[[nodiscard]] std::string accept_for(std::string_view key);
/// A fresh Sec-WebSocket-Key.
[[nodiscard]] std::string random_key();

/// Whether this GET requests a WebSocket.
[[nodiscard]] bool asks_for_websocket(const RequestHeader& request);
/// The answer that refuses the upgrade, with a sentence; nothing if the request is valid.
[[nodiscard]] std::optional<HttpResponse> refuse_upgrade(const RequestHeader& request,
                                                         std::string_view subprotocol,
                                                         const AllowedNames& names = {});
/// 101 for a request accepted by refuse_upgrade().
[[nodiscard]] EmptyResponse make_upgrade(const RequestHeader& request,
                                         std::string_view subprotocol);

[[nodiscard]] EmptyRequest make_upgrade_request(std::string_view host_and_port,
                                                std::string_view path, std::string_view key,
                                                std::string_view subprotocol);
/// The fault in a 101 answer to make_upgrade_request(), as the end of a sentence ("... speaks
/// no roomcast.v1"); nothing if the answer is valid.
[[nodiscard]] std::optional<std::string> fault_in_upgrade(const ResponseHeader& response,
                                                          std::string_view key,
                                                          std::string_view subprotocol);

/// Whether a page from `origin` is served by this very host. Both as in the headers.
[[nodiscard]] bool is_same_host(std::string_view origin, std::string_view host);

}  // namespace roomcast::net
