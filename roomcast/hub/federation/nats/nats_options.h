// SPDX-License-Identifier: Apache-2.0
// Connection options of a hub's NATS cluster, their validation, and the errors of refused
// connections. Threading: no state.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/hub/federation/nats/nats_protocol.h"

namespace roomcast::hub::federation {

struct NatsOptions {
  /// "nats://a:4222", "tls://a:4222", "nats://user:password@a:4222"; at least one. The first that
  /// answers is used.
  std::vector<std::string> servers;
  std::string credentials_file = {};  // .creds of NATS: a user's token and its key; empty: none
  std::string ca_file = {};  // PEM; authorities for the servers' certificates; empty: the system's
  std::string cert_file = {}, key_file = {};  // PEM; this hub's client certificate; empty: none
};

/// kInvalidArgument: not a NATS address, or one of a pair of files is missing. kNotFound: a file
/// cannot be read.
[[nodiscard]] Status check(const NatsOptions& options);

/// Whether every connection must be encrypted.
[[nodiscard]] bool wants_tls(const NatsOptions& options);

struct NatsAddress {
  std::string host;  // without the brackets of an IPv6 address
  std::uint16_t port = 4222;
  bool is_encrypted = false;   // "tls://"
  NatsIdentity identity = {};  // "user:password@", or "token@"
};

/// kInvalidArgument: not such an address; the sentence contains no password.
[[nodiscard]] Result<NatsAddress> parse_nats_address(const std::string& server);

/// Without user and password: "nats://a:4222".
[[nodiscard]] std::string without_secret(const std::string& server);

enum class NatsFault {
  kNoAnswer,
  kNotNats,      // the peer is not a NATS server
  kRefused,      // our credentials, or their absence
  kRejected,     // rejected for another reason
  kNotTrusted,   // the server's certificate, or ours
  kOffersNoTls,  // although TLS is required
};

/// The error for a failed connection to `server`. kClosed: it will fail until the configuration
/// changes. kUnavailable: a retry may help.
[[nodiscard]] Error connect_error(NatsFault fault, const std::string& server,
                                  const NatsOptions& options);

}  // namespace roomcast::hub::federation
