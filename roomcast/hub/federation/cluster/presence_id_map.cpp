// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/cluster/presence_id_map.h"

#include <utility>

#include "roomcast/wire/limits.h"

namespace roomcast::hub::federation {

namespace wpb = wire::pb;

void PresenceIdMap::set(HubId hub, const Entries& people) {
  const auto before = std::exchange(hubs_[hub], {});
  auto& now = hubs_[hub];
  for (const wpb::ViewerEntry& person : people) {
    if (now.size() >= wire::kMaxPeopleHere) break;
    const auto known = before.find(person.id());
    const std::uint32_t number = known == before.end() ? ++newest_ : known->second.id();
    wpb::ViewerEntry& entry = now[person.id()] = person;
    entry.set_id(number);
  }
  if (now.empty()) hubs_.erase(hub);
}

wpb::PeopleHere PresenceIdMap::all() const {
  wpb::PeopleHere all;
  for (const auto& [hub, people] : hubs_) {
    for (const auto& [there, person] : people) *all.add_people() = person;
  }
  return all;
}

wpb::ViewerPoses PresenceIdMap::renamed(HubId hub, const wpb::ViewerPoses& poses) const {
  wpb::ViewerPoses renamed;
  const auto people = hubs_.find(hub);
  if (people == hubs_.end()) return renamed;
  for (const wpb::ViewerPose& pose : poses.poses()) {
    const auto person = people->second.find(pose.viewer_id());
    if (person == people->second.end()) continue;
    wpb::ViewerPose& known = *renamed.add_poses() = pose;
    known.set_viewer_id(person->second.id());
  }
  return renamed;
}

}  // namespace roomcast::hub::federation
