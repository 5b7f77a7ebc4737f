// SPDX-License-Identifier: Apache-2.0
// Opens a connection to the first NATS server that answers: look up the name, connect, encrypt,
// say who this is; bounded in time.
// Threading: call from, and called back on, the thread that runs `io`.
// Source: docs.nats.io, "Client Protocol" (INFO, CONNECT).
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <boost/asio/io_context.hpp>

#include "roomcast/core/result.h"
#include "roomcast/hub/federation/nats/nats_options.h"
#include "roomcast/hub/federation/nats/nats_protocol.h"
#include "roomcast/net/stream.h"

namespace roomcast::hub::federation {

/// Each server; all of it.
inline constexpr std::chrono::milliseconds kConnectWithin{500};

/// To a server that has let this hub in.
struct NatsConnection {
  net::Stream stream;
  bool is_encrypted = false;
  NatsServerInfo info;
  std::string server;                  // as it was named, without user and password
  std::vector<std::uint8_t> received;  // that it said since
};

/// Called once, never from within log_in_to_nats(). Errors: of connect_error(), those that trying
/// again does not help before others; of NatsCredentials::load() and net::TlsClientContext.
using NatsLoginCallback = std::function<void(Result<NatsConnection>)>;

/// An attempt under way. Letting go of it changes nothing.
class NatsLoginAttempt {
 public:
  virtual ~NatsLoginAttempt() = default;
  /// Gives up; the callback is not called any more. No effect once it was.
  virtual void cancel() = 0;
};

/// `options` are legal. The result may be ignored.
std::shared_ptr<NatsLoginAttempt> log_in_to_nats(boost::asio::io_context& io, NatsOptions options,
                                                 NatsLoginCallback callback);

}  // namespace roomcast::hub::federation
