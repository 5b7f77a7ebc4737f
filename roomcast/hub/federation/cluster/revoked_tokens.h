// SPDX-License-Identifier: Apache-2.0
// Tokens that hold no more, as hubs tell each other. Pure.
#pragma once

#include <vector>

#include "roomcast/hub/access/claims.h"
#include "roomcast/hub/federation/cluster/cluster.pb.h"

namespace roomcast::hub::federation {

[[nodiscard]] pb::Revoked revoked_message(const std::vector<hub::Claims>& tokens);

/// Those of which it says what a token can say; the others are left out.
[[nodiscard]] std::vector<hub::Claims> revoked_tokens(const pb::Revoked& message);

}  // namespace roomcast::hub::federation
