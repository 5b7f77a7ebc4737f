// SPDX-License-Identifier: Apache-2.0
// HttpRequest: a request to a server's API (HttpServerOptions::on_request).
#pragma once

#include <functional>
#include <string>

#include "roomcast/net/http_response.h"

namespace roomcast::net {

struct HttpRequest {
  std::string method;         // "GET", "POST", "PUT", "PATCH", "DELETE"; HEAD is reported as GET
  std::string path;           // "/api/v1/rooms", still percent-encoded, without query
  std::string authorization;  // the header's value; empty: none
  std::string body;
  std::string peer;  // numeric address, without port
};

/// Receives the answer; call once, on any thread.
using Respond = std::function<void(HttpResponse)>;

/// "Bearer X" -> "X"; empty for anything else.
[[nodiscard]] std::string bearer_token(const HttpRequest& request);

/// "my%20lab" -> "my lab". Invalid escapes are kept unchanged.
[[nodiscard]] std::string percent_decoded(std::string_view text);

/// The decoded value of the query's part `name`, as browsers read it: of several, the topmost, and
/// "+" is a space. Empty: it has none.
[[nodiscard]] std::string query_value(std::string_view query, std::string_view name);

/// "my lab" -> "my%20lab": letters, digits, - _ . stay. The result is the same in every part of an
/// address.
[[nodiscard]] std::string percent_encoded(std::string_view text);

}  // namespace roomcast::net
