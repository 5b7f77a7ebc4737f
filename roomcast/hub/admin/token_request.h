// SPDX-License-Identifier: Apache-2.0
// What somebody asks for who wants a token, and what he is given: the TokenRequest and NewToken of
// docs/spec/admin.openapi.yaml. Threading: no state; make_token_for() as the book.
#pragma once

#include <nlohmann/json.hpp>

#include "roomcast/core/result.h"
#include "roomcast/hub/store/hub_store.h"

namespace roomcast::hub {

struct TokenRequest {
  static constexpr UnixSeconds kTtl = 8 * 3600;

  Grant grant;
  UnixSeconds ttl = kTtl;
  bool once = false;  // a code instead
};

/// kInvalidArgument, and which field.
[[nodiscard]] Result<TokenRequest> read_token_request(const nlohmann::json& json);

/// A NewToken. Errors of HubStore::issue.
[[nodiscard]] Result<nlohmann::json> make_token_for(const TokenRequest& request, HubStore& book);

/// "#room=R&code=C", what follows a page's address: browsers keep it to themselves.
[[nodiscard]] std::string link_fragment(const std::string& room, const std::string& code);

}  // namespace roomcast::hub
