// SPDX-License-Identifier: Apache-2.0
// The AdminApi's call for the model of a room, which everybody who may view the room may make.
#include <cstdint>
#include <optional>
#include <utility>

#include "roomcast/hub/access/entry.h"
#include "roomcast/hub/admin/admin_answer.h"
#include "roomcast/hub/admin/admin_api.h"
#include "roomcast/hub/admin/path_number.h"

namespace roomcast::hub {

namespace {

net::HttpResponse model_answer(std::shared_ptr<const std::string> model) {
  net::HttpResponse response;
  response.content_type = "application/octet-stream";
  response.cache_control = "no-store";
  response.body = std::move(model);
  return response;
}

}  // namespace

void AdminApi::room_model(const Call& call) const {
  const RoomSettings* settings = registry_.find(call.parameter(0));
  const Claims* claims = call.claims ? &*call.claims : nullptr;
  if (settings == nullptr || !may_know_of(*settings, claims))
    return call.respond(error_answer(no_such_room()));
  if (!may_view(*settings, claims)) {
    return call.respond(
        error_answer(403, "wrong_role", "this request needs a token that may view the room"));
  }
  const bool has_version = call.match.parameters.size() > 1;
  const auto known =
      has_version ? path_number<std::uint64_t>(call.parameter(1)) : std::optional<std::uint64_t>(0);
  if (!known) return call.respond(error_answer(400, "bad_request", "a version is a number"));
  auto changes = models_ == nullptr ? nullptr : models_->changes_after(settings->name, *known);
  call.respond(changes ? model_answer(std::move(changes)) : no_content());
}

}  // namespace roomcast::hub
