// SPDX-License-Identifier: Apache-2.0
// Reads a hub's configuration from file and environment, turns the complete configuration into
// options, and resolves "auto". Threading: no state.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/hub/config/hub_config.h"
#include "roomcast/hub/federation/cluster/cluster_hub.h"
#include "roomcast/hub/federation/upstream/upstream_room.h"
#include "roomcast/hub/server/hub_server.h"
#include "roomcast/net/listen_address.h"

namespace roomcast::hub::daemon {

/// Reads the file, if one is named, then applies the environment over it. An error about the file
/// begins with its name.
[[nodiscard]] Result<hub::HubConfig> find_hub_config(const std::string& file);

/// Whether the hub uses TLS. Unless configured otherwise it does if it is reachable from other
/// machines, with a self-signed certificate if none is named. kInvalidArgument: TLS and `insecure`
/// are both set.
[[nodiscard]] Result<bool> decide_encryption(hub::HubConfig& config,
                                             const net::ListenAddress& listen);

/// The hubs whose rooms this hub relays; nothing: none is configured. kInvalidArgument: not a hub's
/// address. kNotFound: there is no token in the file.
[[nodiscard]] Result<std::optional<hub::federation::UpstreamOptions>> upstream_of(
    const hub::HubConfig& config);

/// The NATS cluster over which this hub shares its rooms; nothing: no server is configured. Errors
/// of hub::federation::check().
[[nodiscard]] Result<std::optional<hub::federation::ClusterOptions>> cluster_of(
    const hub::HubConfig& config);

/// All options but certificate, folders and log. Unless configured otherwise, a hub that is
/// reachable from other machines requires tokens.
[[nodiscard]] Result<hub::HubOptions> hub_options_of(const hub::HubConfig& config,
                                                     const net::ListenAddress& listen,
                                                     bool encrypted);

}  // namespace roomcast::hub::daemon
