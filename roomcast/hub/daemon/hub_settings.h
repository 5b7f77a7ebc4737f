// SPDX-License-Identifier: Apache-2.0
// What a hub's configuration comes to: file, environment and command line put together, and what
// "auto" means there. Threading: no state.
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

/// What the file says (no file: nothing), and over it the environment. The sentence of an error
/// begins with the file's name.
[[nodiscard]] Result<hub::HubConfig> find_hub_config(const std::string& file);

/// Does the hub encrypt? Beyond this machine it does unless told otherwise, with a certificate that
/// it makes for itself where none is named. kInvalidArgument: it cannot do both.
[[nodiscard]] Result<bool> decide_encryption(hub::HubConfig& config, const net::ListenAddress& listen);

/// Whose rooms the hub serves on; nothing where no other hub is named. kInvalidArgument: not a
/// hub's address. kNotFound: there is no token in the file.
[[nodiscard]] Result<std::optional<hub::federation::UpstreamOptions>> upstream_of(
    const hub::HubConfig& config);

/// With whom it shares its rooms; nothing where no NATS server is named. Errors of
/// hub::federation::check().
[[nodiscard]] Result<std::optional<hub::federation::ClusterOptions>> cluster_of(
    const hub::HubConfig& config);

/// All but certificate, folders and log. Whoever reaches a hub from elsewhere needs a token unless
/// the configuration says that anyone may come.
[[nodiscard]] Result<hub::HubOptions> hub_options_of(const hub::HubConfig& config,
                                                     const net::ListenAddress& listen, bool encrypted);

}  // namespace roomcast::hub::daemon
