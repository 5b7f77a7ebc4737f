// SPDX-License-Identifier: Apache-2.0
// How a hub reaches its NATS cluster, checked, as libnats wants it, and what its refusals mean.
// Threading: no state.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <nats/nats.h>

#include "roomcast/core/result.h"

namespace roomcast::cluster {

inline constexpr std::chrono::milliseconds kConnectWithin{500};
/// One frame set of a room goes out in one write.
inline constexpr int kIoBytes = 256 << 10;

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

using NatsOptionsPtr = std::unique_ptr<natsOptions, decltype(&natsOptions_Destroy)>;
/// kInvalidArgument: libnats cannot use one of the files; the sentence says which.
[[nodiscard]] Result<NatsOptionsPtr> libnats_options(const NatsOptions& options);

/// Without user and password: "nats://a:4222".
[[nodiscard]] std::string without_secret(const std::string& server);

/// Why there is no connection. kClosed: and there will be none before somebody changes something.
/// kUnavailable: trying again may help.
[[nodiscard]] Error connect_error(natsStatus status, const NatsOptions& options);

}  // namespace roomcast::cluster
