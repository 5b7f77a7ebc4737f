// SPDX-License-Identifier: Apache-2.0
// The aligner that comes with a hub: in the same process, a client of it like any other.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "roomcast/aligner/room_aligner.h"
#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/net/tls/fingerprint.h"

namespace roomcast::cli {

struct HubAlignerOptions {
  std::string listen_address = "127.0.0.1";  // of the hub
  std::uint16_t port = 0;
  std::optional<net::Fingerprint> certificate;  // of a hub that encrypts
  std::string key;
  LogSink log;
};

/// Nobody can guess it.
[[nodiscard]] std::string make_aligner_key();

/// How the hub is reached from its own machine.
[[nodiscard]] std::string own_hub_url(const HubAlignerOptions& options);

[[nodiscard]] Result<std::unique_ptr<aligner::RoomAligner>> start_hub_aligner(
    const HubAlignerOptions& options);

}  // namespace roomcast::cli
