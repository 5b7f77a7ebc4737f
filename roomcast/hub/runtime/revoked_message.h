// SPDX-License-Identifier: Apache-2.0
// What a hub tells hubs behind it of tokens that hold no more: those for the room that they serve
// on, without whom they were for. Pure.
#pragma once

#include <string>
#include <vector>

#include "roomcast/hub/access/claims.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

/// Of those that cover the room, in messages of at most kMaxRevokedTokens; none: there are none.
[[nodiscard]] std::vector<wire::pb::Control> revoked_messages(const std::vector<Claims>& revoked,
                                                              const std::string& room);

/// What a hub says of the room that we serve on. Of another room, or nonsense: left out.
[[nodiscard]] std::vector<Claims> revoked_claims(const wire::pb::RevokedTokens& message,
                                                 const std::string& room);

}  // namespace roomcast::hub
