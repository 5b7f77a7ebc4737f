// SPDX-License-Identifier: Apache-2.0
// Encodes and decodes revoked tokens for the exchange between hubs. Pure.
#pragma once

#include <vector>

#include "roomcast/hub/access/claims.h"
#include "roomcast/hub/federation/cluster/cluster.pb.h"

namespace roomcast::hub::federation {

[[nodiscard]] pb::Revoked revoked_message(const std::vector<hub::Claims>& tokens);

/// The tokens with valid content; others are left out.
[[nodiscard]] std::vector<hub::Claims> revoked_tokens(const pb::Revoked& message);

}  // namespace roomcast::hub::federation
