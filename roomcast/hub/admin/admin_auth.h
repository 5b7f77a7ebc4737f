// SPDX-License-Identifier: Apache-2.0
// AdminAuth: who asks over HTTP? A token that is no good is answered here and held against the
// address it came from, as a bad join is. Threading: the rooms' thread; whoever comes in is
// announced later, from there.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "roomcast/core/log.h"
#include "roomcast/hub/runtime/room_registry.h"
#include "roomcast/hub/store/store_worker.h"
#include "roomcast/net/http_request.h"

namespace roomcast::hub {

/// Who makes a call, and how it is answered so that the log tells of it.
struct Caller {
  std::optional<Claims> claims;  // nothing: showed no token
  net::Respond respond;

  [[nodiscard]] bool is_admin_of(std::string_view room) const {
    return claims && claims->grant.role == TokenRole::kAdmin && covers(claims->grant, room);
  }
  [[nodiscard]] bool is_hub_admin() const { return is_admin_of(kAllRooms); }
};

class AdminAuth {
 public:
  AdminAuth(RoomRegistry& hall, StoreWorker& store_worker, LogSink log = {});

  /// `enter` is called with who asks, unless they are refused: for a token that is no good, or for
  /// none where one is needed.
  void admit(const net::HttpRequest& request, bool needs_token, net::Respond respond,
             std::function<void(Caller)> enter);

 private:
  RoomRegistry& hall_;
  StoreWorker& store_worker_;
  const LogSink log_;
};

}  // namespace roomcast::hub
