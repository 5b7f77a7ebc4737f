// SPDX-License-Identifier: Apache-2.0
// PresenceIdMap: the people in a room at other hubs. Each hub numbers its people independently, so
// this hub assigns them unique IDs of its own. Pure.
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

  /// Sets all people at this hub or behind it; more than kMaxPeopleHere are left out.
  void set(HubId hub, const Entries& people);
  /// All people, with our IDs.
  [[nodiscard]] wire::pb::PeopleHere all() const;
  /// The poses of people that this hub has reported, with our IDs.
  [[nodiscard]] wire::pb::ViewerPoses renamed(HubId hub, const wire::pb::ViewerPoses& poses) const;

 private:
  std::map<HubId, std::map<std::uint32_t, wire::pb::ViewerEntry>> hubs_;  // by IDs there
  std::uint32_t newest_ = 0;
};

}  // namespace roomcast::hub::federation
