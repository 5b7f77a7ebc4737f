// SPDX-License-Identifier: Apache-2.0
// The AdminApi's call for the model of a room, which everybody who may view the room may make.
#include <charconv>
#include <optional>
#include <utility>

#include "roomcast/hub/access/entry.h"
#include "roomcast/hub/admin/admin_answer.h"
#include "roomcast/hub/admin/admin_api.h"

namespace roomcast::hub {

namespace {

/// Digits only.
std::optional<std::uint64_t> version_in(const std::string& text) {
  std::uint64_t version = 0;
  const char* const end = text.data() + text.size();
  const auto [read_to, error] = std::from_chars(text.data(), end, version);
  if (error != std::errc() || read_to != end) return std::nullopt;
  return version;
}

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
  if (settings == nullptr || !may_know_of(*settings, claims)) {
    return call.respond(error_answer(
        404, "not_found", "this hub has no such room, or the room needs a token of its own"));
  }
  if (!may_view(*settings, claims)) {
    return call.respond(
        error_answer(403, "wrong_role", "this request needs a token that may view the room"));
  }
  const auto known = call.match.parameters.size() > 1 ? version_in(call.parameter(1)) : 0;
  if (!known) return call.respond(error_answer(400, "bad_request", "a version is a number"));
  auto changes = models_ == nullptr ? nullptr : models_->changes_after(settings->name, *known);
  call.respond(changes ? model_answer(std::move(changes)) : no_content());
}

}  // namespace roomcast::hub
