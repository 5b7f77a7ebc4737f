// SPDX-License-Identifier: Apache-2.0
// AdminAuth: authenticates HTTP requests. A request with a bad token is refused here and counts
// towards a ban of its address, as a bad join does. Threading: the rooms' thread; `enter` is called
// later, on that thread.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "roomcast/core/log.h"
#include "roomcast/hub/runtime/room_registry.h"
#include "roomcast/hub/store/store_worker.h"
#include "roomcast/net/http_request.h"

namespace roomcast::hub {

/// The caller of a request, and a `respond` that also writes the audit log.
struct Caller {
  std::optional<Claims> claims;  // nothing: no token was presented
  net::Respond respond;

  [[nodiscard]] bool is_admin_of(std::string_view room) const {
    return claims && claims->grant.role == TokenRole::kAdmin && covers(claims->grant, room);
  }
  [[nodiscard]] bool is_hub_admin() const { return is_admin_of(kAllRooms); }
};

class AdminAuth {
 public:
  AdminAuth(RoomRegistry& registry, StoreWorker& store_worker, LogSink log = {});

  /// Calls `enter` with the caller, unless the request is refused because its token is bad, or
  /// missing where one is required.
  void admit(const net::HttpRequest& request, bool needs_token, net::Respond respond,
             std::function<void(Caller)> enter);

 private:
  RoomRegistry& registry_;
  StoreWorker& store_worker_;
  const LogSink log_;
};

}  // namespace roomcast::hub
