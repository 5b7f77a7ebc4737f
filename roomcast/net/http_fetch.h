// SPDX-License-Identifier: Apache-2.0
// Asks a hub for something over HTTP and waits for the answer. Thread-safe (no state).
// Source: HTTP by Boost.Beast.
#pragma once

#include <chrono>
#include <cstddef>
#include <stop_token>
#include <string>

#include "roomcast/core/result.h"
#include "roomcast/net/hub_url.h"

namespace roomcast::net {

struct FetchOptions {
  std::string token;                         // sent as a bearer token; empty: none
  std::size_t max_bytes = 64'000'000;        // of the body; a longer one is refused
  std::chrono::milliseconds within{60'000};  // from the call to the whole answer
  std::stop_token stop = {};                 // ends the wait
};

struct FetchedAnswer {
  int status = 0;
  std::string body;
};

/// GET `target` ("/api/v1/..."). Any HTTP status is an answer. Errors: those of open_stream;
/// kUnavailable without an answer in time, kClosed once stopped, kUnsupported for what is no HTTP
/// or too long.
[[nodiscard]] Result<FetchedAnswer> fetch(const HubUrl& url, const std::string& target,
                                          const FetchOptions& options);

}  // namespace roomcast::net
