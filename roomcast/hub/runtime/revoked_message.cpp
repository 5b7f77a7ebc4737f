// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/revoked_message.h"

#include "roomcast/wire/limits.h"

namespace roomcast::hub {

namespace pb = wire::pb;

std::vector<pb::Control> revoked_messages(const std::vector<Claims>& revoked,
                                          const std::string& room) {
  std::vector<pb::Control> messages;
  for (const Claims& claims : revoked) {
    if (!covers(claims.grant, room)) continue;
    const bool is_full = !messages.empty() &&
                         messages.back().revoked_tokens().tokens_size() >= wire::kMaxRevokedTokens;
    if (messages.empty() || is_full) messages.emplace_back();
    pb::RevokedToken& token = *messages.back().mutable_revoked_tokens()->add_tokens();
    token.set_id(claims.id);
    token.set_room(claims.grant.room);
    token.set_role(std::string(name_of(claims.grant.role)));
    token.set_issued_at(claims.issued_at);
    token.set_expires_at(claims.expires_at);
  }
  return messages;
}

std::vector<Claims> revoked_claims(const pb::RevokedTokens& message, const std::string& room) {
  std::vector<Claims> revoked;
  for (const pb::RevokedToken& token : message.tokens()) {
    const auto role = token_role(token.role());
    if (!role) continue;
    Claims claims{.id = token.id(),
                  .grant = {.room = token.room(), .role = *role},
                  .issued_at = token.issued_at(),
                  .expires_at = token.expires_at()};
    if (covers(claims.grant, room)) revoked.push_back(std::move(claims));
  }
  return revoked;
}

}  // namespace roomcast::hub
