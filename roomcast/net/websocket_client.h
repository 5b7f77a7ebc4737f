// SPDX-License-Identifier: Apache-2.0
// Opens a WebSocket to a hub: resolves the name, connects, and performs the TLS and WebSocket
// handshakes, within a time limit.
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
#include "roomcast/net/stream_client.h"
#include "roomcast/net/websocket_connection.h"

namespace roomcast::net {

struct ClientOptions {
  std::string subprotocol = "roomcast.v1";
  std::size_t max_message_bytes = std::size_t{2} << 20;
  std::chrono::milliseconds connect_within{5'000};  // name, TCP and handshakes together
  ConnectionTimings timings = {};
  int max_segment_bytes = 0;    // of TCP; 0: as the network allows
  double pace_bytes_per_s = 0;  // of what TCP carries; 0: as fast as the network allows
};

/// Called once, never from within connect(). The connection is open and must be started by start().
/// Errors: kNotFound (no such host), kUnavailable (no listener, no answer in time, or the hub is
/// full), kUnsupported (an answer that is not from a hub of this version, or a certificate that
/// cannot be trusted).
using ConnectCallback = std::function<void(Result<std::shared_ptr<WebSocketConnection>>)>;

/// The result may be ignored.
std::shared_ptr<ConnectAttempt> connect(boost::asio::io_context& io, const HubUrl& url,
                                        ClientOptions options, ConnectCallback callback);

}  // namespace roomcast::net
