// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/request_framing.h"

#include <boost/beast/core/string.hpp>
#include <boost/beast/http/field.hpp>

namespace roomcast::net {

namespace http = boost::beast::http;

std::optional<HttpResponse> refuse_ambiguous(const http::header<true, http::fields>& request) {
  if (request.count(http::field::host) > 1 || request.count(http::field::origin) > 1) {
    return text_response(400, "A request has one Host and at most one Origin.\n");
  }
  const auto codings = request.count(http::field::transfer_encoding);
  if (codings == 0) return std::nullopt;
  if (codings > 1 || !boost::beast::iequals(request[http::field::transfer_encoding], "chunked")) {
    return text_response(501, "The only Transfer-Encoding that this server knows is chunked.\n");
  }
  if (request.version() < 11) {
    return text_response(400, "A request in HTTP/1.0 has no Transfer-Encoding.\n");
  }
  return std::nullopt;
}

}  // namespace roomcast::net
