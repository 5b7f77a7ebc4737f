// SPDX-License-Identifier: Apache-2.0
// OwnHub: how the services in a hub's process reach that hub as its clients: the address at which
// it listens, its certificate, and a token. They know it before the hub is open, because the hub
// is opened with them. Threading: thread-safe.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "roomcast/net/tls/fingerprint.h"

namespace roomcast::hub::daemon {

struct OwnHubAddress {
  std::string listen_address = "127.0.0.1";
  std::uint16_t port = 0;
  std::optional<net::Fingerprint> certificate = {};  // if the hub uses TLS
};

class OwnHub {
 public:
  struct Access {
    std::string url, token;
  };

  /// The hub is open and accepts this token. Must be called before the hub runs.
  void opened(OwnHubAddress address, std::string token);
  /// The hub's certificate was renewed.
  void trust(const net::Fingerprint& certificate);

  /// For a client on the hub's own machine.
  [[nodiscard]] Access access() const;

 private:
  mutable std::mutex mutex_;
  OwnHubAddress address_;
  std::string token_;
};

}  // namespace roomcast::hub::daemon
