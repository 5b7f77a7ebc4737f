// SPDX-License-Identifier: Apache-2.0
// Opens a connection to the first NATS server that answers: resolves the name, connects, encrypts
// and authenticates, within a time limit.
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

/// Time limit per server, for all steps together.
inline constexpr std::chrono::milliseconds kConnectWithin{500};

/// A connection to a server that has accepted this hub.
struct NatsConnection {
  net::Stream stream;
  bool is_encrypted = false;
  NatsServerInfo info;
  std::string server;                  // as configured, without user and password
  std::vector<std::uint8_t> received;  // bytes received after the login
};

/// Called once, never from within log_in_to_nats(). Errors: those of connect_error(), preferably
/// one that a retry cannot resolve; of NatsCredentials::load() and net::TlsClientContext.
using NatsLoginCallback = std::function<void(Result<NatsConnection>)>;

/// A pending attempt. Destroying it does not cancel the attempt.
class NatsLoginAttempt {
 public:
  virtual ~NatsLoginAttempt() = default;
  /// Cancels the attempt; the callback is not called any more. No effect after the callback.
  virtual void cancel() = 0;
};

/// `options` must be valid. The result may be ignored.
std::shared_ptr<NatsLoginAttempt> log_in_to_nats(boost::asio::io_context& io, NatsOptions options,
                                                 NatsLoginCallback callback);

}  // namespace roomcast::hub::federation
