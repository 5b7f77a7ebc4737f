// SPDX-License-Identifier: Apache-2.0
// PresenceIdMap: who watches a room at other hubs. Each hub counts its people by itself, so here
// they get numbers that tell them apart. Pure.
#pragma once

#include <cstdint>
#include <map>

#include <google/protobuf/repeated_field.h>

#include "roomcast/hub/federation/cluster/hub_id.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub::federation {

class PresenceIdMap {
 public:
  using Entries = google::protobuf::RepeatedPtrField<wire::pb::ViewerEntry>;

  /// All who are at this hub now, or behind it; more than kMaxPeopleHere are left out.
  void are(HubId hub, const Entries& people);
  /// With our numbers.
  [[nodiscard]] wire::pb::PeopleHere all() const;
  /// Those whom this hub has told of, with our numbers.
  [[nodiscard]] wire::pb::ViewerPoses renamed(HubId hub, const wire::pb::ViewerPoses& poses) const;

 private:
  std::map<HubId, std::map<std::uint32_t, wire::pb::ViewerEntry>> hubs_;  // by ids there
  std::uint32_t newest_ = 0;
};

}  // namespace roomcast::hub::federation
