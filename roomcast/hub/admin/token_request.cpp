// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/token_request.h"

#include "roomcast/net/http_request.h"

namespace roomcast::hub {

namespace {

using Json = nlohmann::json;

}  // namespace

Result<TokenRequest> read_token_request(const Json& json) {
  TokenRequest request;
  for (const auto& [key, value] : json.items()) {
    if (key == "room" && value.is_string()) {
      request.grant.room = value.get<std::string>();
    } else if (key == "role" && value.is_string()) {
      const auto role = token_role(value.get<std::string>());
      if (!role) return invalid_argument("a token's role is sensor, viewer, hub or admin");
      request.grant.role = *role;
    } else if (key == "name" && value.is_string()) {
      request.grant.name = value.get<std::string>();
    } else if (key == "ttl_s" && value.is_number_integer()) {
      request.ttl = value.get<UnixSeconds>();
    } else if (key == "once" && value.is_boolean()) {
      request.once = value.get<bool>();
    } else {
      return invalid_argument("a token has no \"" + key + "\", or not with this value");
    }
  }
  if (!json.contains("room") || !json.contains("role"))
    return invalid_argument("say for which room and role");
  return request;
}

Result<Json> make_token_for(const TokenRequest& request, HubStore& store) {
  if (request.once) {
    const auto made = store.issue_code(request.grant, request.ttl);
    if (!made) return made.error();
    return Json{{"id", made->id},
                {"code", made->code},
                {"fragment", link_fragment(request.grant.room, made->code)},
                {"expires_at", made->expires_at}};
  }
  const auto made = store.issue(request.grant, request.ttl);
  if (!made) return made.error();
  return Json{
      {"id", made->claims.id}, {"token", made->token}, {"expires_at", made->claims.expires_at}};
}

std::string link_fragment(const std::string& room, const std::string& code) {
  const std::string of_code = "code=" + net::percent_encoded(code);
  if (room == kAllRooms) return "#" + of_code;
  return "#room=" + net::percent_encoded(room) + "&" + of_code;
}

}  // namespace roomcast::hub
