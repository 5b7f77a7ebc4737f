// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/cluster/revoked_tokens.h"

#include <string>

#include "roomcast/wire/limits.h"
#include "roomcast/wire/name_check.h"

namespace roomcast::hub::federation {
namespace {

bool is_legal(const pb::RevokedToken& token) {
  return !token.id().empty() && token.id().size() <= wire::kMaxNameBytes &&
         hub::token_role(token.role()).has_value() && wire::check_name(token.room(), "room").ok() &&
         wire::check_name(token.name(), "name").ok();
}

}  // namespace

pb::Revoked revoked_message(const std::vector<hub::Claims>& tokens) {
  pb::Revoked message;
  for (const hub::Claims& token : tokens) {
    pb::RevokedToken& revoked = *message.add_tokens();
    revoked.set_id(token.id);
    revoked.set_room(token.grant.room);
    revoked.set_role(std::string(hub::name_of(token.grant.role)));
    revoked.set_name(token.grant.name);
    revoked.set_issued_at(token.issued_at);
    revoked.set_expires_at(token.expires_at);
  }
  return message;
}

std::vector<hub::Claims> revoked_tokens(const pb::Revoked& message) {
  std::vector<hub::Claims> tokens;
  for (const pb::RevokedToken& token : message.tokens()) {
    if (!is_legal(token)) continue;
    tokens.push_back({.id = token.id(),
                      .grant = {.room = token.room(),
                                .role = *hub::token_role(token.role()),
                                .name = token.name()},
                      .issued_at = token.issued_at(),
                      .expires_at = token.expires_at()});
  }
  return tokens;
}

}  // namespace roomcast::hub::federation
