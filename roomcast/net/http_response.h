// SPDX-License-Identifier: Apache-2.0
// HttpResponse: the answer to an HTTP request. The body is shared, so that a file in memory is
// never copied.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/net/long_body.h"

namespace roomcast::net {

struct HttpResponse {
  int status = 200;
  std::string content_type = "text/plain; charset=utf-8";
  std::shared_ptr<const std::string> body = {};    // null = empty
  std::shared_ptr<const std::string> gzip = {};    // for clients that accept gzip; null = none
  std::shared_ptr<const LongBody> long_body = {};  // instead of `body`; null = none
  /// Quoted, as in the header; empty = none. A request with a matching If-None-Match is answered
  /// with 304.
  std::string etag = {};
  std::string cache_control = "no-cache";
  std::vector<std::pair<std::string, std::string>> headers =
      {};  // in addition to those set by the server
};

/// A short plain-text answer.
[[nodiscard]] inline HttpResponse text_response(int status, std::string text) {
  return {.status = status,
          .content_type = "text/plain; charset=utf-8",
          .body = std::make_shared<const std::string>(std::move(text)),
          .gzip = {},
          .long_body = {},
          .etag = {},
          .cache_control = "no-store",
          .headers = {}};
}

}  // namespace roomcast::net
