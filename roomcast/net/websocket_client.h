// SPDX-License-Identifier: Apache-2.0
// Opens a WebSocket to a hub: look up the name, connect, encrypt, shake hands; bounded in time.
// Threading: call from, and called back on, the thread that runs `io`.
// Source: RFC 6455 section 4.1 (client handshake); HTTP by Boost.Beast.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include <boost/asio/io_context.hpp>

#include "roomcast/core/result.h"
#include "roomcast/net/hub_url.h"
#include "roomcast/net/websocket_connection.h"

namespace roomcast::net {

struct ClientOptions {
  std::string subprotocol = "roomcast.v1";
  std::size_t max_message_bytes = std::size_t{2} << 20;
  std::chrono::milliseconds connect_within{5'000};  // name, TCP and handshake together
  ConnectionTimings timings = {};
};

/// Called once, never from within connect(). The connection is open and waits for start().
/// Errors: kNotFound (no such host), kUnavailable (nobody listens there, or no answer in time, or
/// the hub is full), kUnsupported (answers, but is no hub of this version, or shows a certificate
/// that cannot be trusted).
using ConnectCallback = std::function<void(Result<std::shared_ptr<WebSocketConnection>>)>;

/// An attempt under way. Letting go of it changes nothing.
class ConnectAttempt {
 public:
  virtual ~ConnectAttempt() = default;
  /// Gives up; the callback is not called any more. No effect once it was.
  virtual void cancel() = 0;
};

/// The result may be ignored.
std::shared_ptr<ConnectAttempt> connect(boost::asio::io_context& io, const HubUrl& url,
                                        ClientOptions options, ConnectCallback callback);

}  // namespace roomcast::net
