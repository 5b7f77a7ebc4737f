// SPDX-License-Identifier: Apache-2.0
// UpstreamHub: the backplane of a hub that relays the rooms of another hub. A room is pulled while
// it has viewers here, and for a short time afterwards, so that a viewer who reloads the page finds
// it unchanged. Threading: the rooms' thread.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "roomcast/hub/federation/upstream/upstream_room.h"
#include "roomcast/hub/runtime/backplane.h"
#include "roomcast/net/timer.h"

namespace roomcast::hub::federation {

class UpstreamHub final : public hub::Backplane {
 public:
  UpstreamHub(UpstreamOptions options, hub::BackplaneContext context);

  void watch(const std::string& room, bool is_watched) override;
  [[nodiscard]] hub::BackplaneStats stats() const override;

 private:
  struct Pulled {
    UpstreamRoom room;
    net::Timer end;  // of a room without viewers
    bool is_watched = true;
  };
  using Rooms = std::map<std::string, std::unique_ptr<Pulled>>;  // by name

  void pull(const std::string& room);
  void end_later(const std::string& room, Pulled& pulled);
  void end(Rooms::iterator room);

  const UpstreamOptions options_;
  const hub::BackplaneContext context_;
  hub::BackplaneStats ended_;  // traffic of rooms that are no longer pulled
  Rooms rooms_;
};

}  // namespace roomcast::hub::federation
