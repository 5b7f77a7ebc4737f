// SPDX-License-Identifier: Apache-2.0
// Requests that two programs can read in two ways. A proxy before this server decides by its
// reading, this server by another: so a request is smuggled past the proxy. Such requests are
// refused, whatever they ask for.
// Source: RFC 9112 sections 3.2 (Host), 6.1 and 6.3 (Transfer-Encoding), 11.2 (smuggling);
// RFC 6454 section 7.3 (Origin).
#pragma once

#include <optional>

#include <boost/beast/http/fields.hpp>
#include <boost/beast/http/message.hpp>

#include "roomcast/net/http_response.h"

namespace roomcast::net {

/// The answer that refuses the request: 400 for two Host or two Origin fields and for a transfer
/// coding in HTTP/1.0, 501 for any transfer coding but `chunked`. Nothing if there is one reading.
/// Close the connection after it: where the next request begins is not known.
[[nodiscard]] std::optional<HttpResponse> refuse_ambiguous(
    const boost::beast::http::header<true, boost::beast::http::fields>& request);

}  // namespace roomcast::net
