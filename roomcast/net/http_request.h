// SPDX-License-Identifier: Apache-2.0
// HttpRequest: what a server's own addresses are asked (HttpServerOptions::on_request).
#pragma once

#include <functional>
#include <string>

#include "roomcast/net/http_response.h"

namespace roomcast::net {

struct HttpRequest {
  std::string method;         // "GET", "POST", "PUT", "PATCH", "DELETE"; HEAD comes as GET
  std::string path;           // "/api/v1/rooms", still percent-encoded, without query
  std::string authorization;  // the header's value; empty: none
  std::string body;
  std::string peer;  // numeric address, without port
};

/// Takes the answer, once, on any thread.
using Respond = std::function<void(HttpResponse)>;

/// "Bearer X" -> "X"; empty for anything else.
[[nodiscard]] std::string bearer_token(const HttpRequest& request);

/// "my%20lab" -> "my lab". What is no such escape stays as it is.
[[nodiscard]] std::string percent_decoded(std::string_view text);

}  // namespace roomcast::net
