// SPDX-License-Identifier: Apache-2.0
// How a hub reaches its NATS cluster, checked, and what its refusals mean. Threading: no state.
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
  /// answers is taken.
  std::vector<std::string> servers;
  std::string credentials_file = {};  // .creds of NATS: a user's token and its key; empty: none
  std::string ca_file = {};  // PEM; who signs the servers' certificates; empty: as in the system
  std::string cert_file = {},
              key_file = {};  // PEM; by which the servers know this hub; empty: not by that
};

/// kInvalidArgument: no NATS address, or half of a pair of files. kNotFound: a file cannot be read.
[[nodiscard]] Status check(const NatsOptions& options);

/// Every connection is to be encrypted.
[[nodiscard]] bool wants_tls(const NatsOptions& options);

struct NatsAddress {
  std::string host;  // without the brackets of an IPv6 address
  std::uint16_t port = 4222;
  bool is_encrypted = false;   // "tls://"
  NatsIdentity identity = {};  // "user:password@", or "token@"
};

/// kInvalidArgument: not such an address; the sentence shows no password.
[[nodiscard]] Result<NatsAddress> parse_nats_address(const std::string& server);

/// Without user and password: "nats://a:4222".
[[nodiscard]] std::string without_secret(const std::string& server);

enum class NatsFault {
  kNoAnswer,
  kNoNats,       // somebody else answers
  kRefused,      // our name, or that we have none
  kNotTaken,     // for another reason
  kNotTrusted,   // its certificate, or ours
  kOffersNoTls,  // where it is demanded
};

/// Why there is no connection to `server`. kClosed: and there will be none before somebody changes
/// something. kUnavailable: trying again may help.
[[nodiscard]] Error connect_error(NatsFault fault, const std::string& server,
                                  const NatsOptions& options);

}  // namespace roomcast::hub::federation
