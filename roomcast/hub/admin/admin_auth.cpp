// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/admin_auth.h"

#include <utility>

#include "roomcast/hub/admin/admin_answer.h"
#include "roomcast/hub/admin/admin_audit.h"

namespace roomcast::hub {

AdminAuth::AdminAuth(RoomRegistry& registry, StoreWorker& store_worker, LogSink log)
    : registry_(registry), store_worker_(store_worker), log_(std::move(log)) {}

void AdminAuth::admit(const net::HttpRequest& request, bool needs_token, net::Respond respond,
                      std::function<void(Caller)> enter) {
  AuditedCall call{.method = request.method,
                   .path = request.path,
                   .peer = request.peer,
                   .is_frequent = request.path.ends_with("/together")};
  const std::string token = net::bearer_token(request);
  if (token.empty()) {
    Caller anonymous{std::nullopt, audited(log_, std::move(call), std::move(respond))};
    if (!needs_token) return enter(std::move(anonymous));
    return anonymous.respond(error_answer(
        Refusal{wire::pb::ERROR_UNAUTHENTICATED,
                "this request needs an admin's token, in the header Authorization: Bearer TOKEN"}));
  }
  store_worker_.ask([token](HubStore& store) { return store.check(token); },
                    [this, call = std::move(call), respond = std::move(respond),
                     enter = std::move(enter)](const Verdict<Claims>& verdict) mutable {
                      if (const Refusal* why = refusal(verdict)) {
                        registry_.count_fault(call.peer, *why);
                        return audited(log_, std::move(call),
                                       std::move(respond))(error_answer(*why));
                      }
                      const Claims& claims = std::get<Claims>(verdict);
                      call.token_id = claims.id;
                      call.name = claims.grant.name;
                      enter({claims, audited(log_, std::move(call), std::move(respond))});
                    });
}

}  // namespace roomcast::hub
