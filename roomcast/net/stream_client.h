// SPDX-License-Identifier: Apache-2.0
// Opens a connection to a hub: resolves the name, connects, and performs the TLS handshake. Has no
// time limit of its own. Threading: call from, and called back on, the thread that runs `io`.
#pragma once

#include <functional>
#include <memory>

#include <boost/asio/io_context.hpp>

#include "roomcast/core/result.h"
#include "roomcast/net/hub_url.h"
#include "roomcast/net/stream.h"

namespace roomcast::net {

struct StreamOptions {
  int max_segment_bytes = 0;    // of TCP; 0: as the network allows
  double pace_bytes_per_s = 0;  // of what TCP carries; 0: as fast as the network allows
};

/// A pending attempt. Destroying it does not cancel the attempt.
class ConnectAttempt {
 public:
  virtual ~ConnectAttempt() = default;
  /// Cancels the attempt; the callback is not called any more. No effect after the callback.
  virtual void cancel() = 0;
};

/// Called once, never from within open_stream(). Errors: kNotFound (no such host), kUnavailable (no
/// listener), kUnsupported (a certificate that cannot be trusted).
using StreamCallback = std::function<void(Result<Stream>)>;

/// The result may be ignored.
std::shared_ptr<ConnectAttempt> open_stream(boost::asio::io_context& io, const HubUrl& url,
                                            const StreamOptions& options, StreamCallback callback);

}  // namespace roomcast::net
