// SPDX-License-Identifier: Apache-2.0
// A request for a token and its answer: TokenRequest and NewToken of docs/spec/admin.openapi.yaml.
// Threading: no state; make_token_for() as HubStore.
#pragma once

#include <nlohmann/json.hpp>

#include "roomcast/core/result.h"
#include "roomcast/hub/store/hub_store.h"

namespace roomcast::hub {

struct TokenRequest {
  static constexpr UnixSeconds kTtl = 8 * 3600;

  Grant grant;
  UnixSeconds ttl = kTtl;
  bool once = false;  // issue a one-time code instead
};

/// kInvalidArgument: the message names the field.
[[nodiscard]] Result<TokenRequest> read_token_request(const nlohmann::json& json);

/// Issues a token or code and returns it as a NewToken. Errors of HubStore::issue.
[[nodiscard]] Result<nlohmann::json> make_token_for(const TokenRequest& request, HubStore& store);

/// "#room=R&code=C", to be appended to a page's address: browsers do not send fragments.
[[nodiscard]] std::string link_fragment(const std::string& room, const std::string& code);

}  // namespace roomcast::hub
