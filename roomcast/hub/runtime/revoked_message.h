// SPDX-License-Identifier: Apache-2.0
// Messages to hubs that relay a room, about revoked tokens for that room. They leave out the names
// of the tokens' owners. Pure.
#pragma once

#include <string>
#include <vector>

#include "roomcast/hub/access/claims.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

/// The revoked tokens that are valid for the room, at most kMaxRevokedTokens per message; empty:
/// there are none.
[[nodiscard]] std::vector<wire::pb::Control> revoked_messages(const std::vector<Claims>& revoked,
                                                              const std::string& room);

/// The tokens that the upstream hub reports as revoked for the room that this hub relays. Leaves
/// out tokens of other rooms and invalid entries.
[[nodiscard]] std::vector<Claims> revoked_claims(const wire::pb::RevokedTokens& message,
                                                 const std::string& room);

}  // namespace roomcast::hub
