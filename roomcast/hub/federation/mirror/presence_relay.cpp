// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/mirror/presence_relay.h"

#include <algorithm>
#include <utility>

#include "roomcast/wire/limits.h"

namespace roomcast::hub::federation {
namespace {

namespace wpb = wire::pb;

wpb::ViewerEntry reportable(const wpb::ViewerEntry& person) {
  wpb::ViewerEntry entry = person;
  entry.clear_through();  // an ID that is meaningless on another hub
  return entry;
}

bool comes_from_backplane(const wpb::ViewerEntry& person) {
  return person.hubs_away() > 0 && person.through() == 0;
}

}  // namespace

bool PresenceRelay::take(const wpb::Roster& roster) {
  std::map<std::uint32_t, wpb::ViewerEntry> people;  // sorted by ID: a roster is unordered
  for (const wpb::ViewerEntry& person : roster.viewers()) {
    if (person.relays() || comes_from_backplane(person)) continue;
    people[person.id()] = reportable(person);
  }
  wpb::PeopleHere now;
  for (auto& [id, person] : people) {
    if (now.people_size() < wire::kMaxPeopleHere) *now.add_people() = std::move(person);
  }
  std::erase_if(poses_, [&](const auto& pose) { return !people.contains(pose.first); });
  const bool has_changed = now.SerializeAsString() != people_.SerializeAsString();
  people_ = std::move(now);
  return has_changed;
}

wpb::ViewerPoses PresenceRelay::take(const wpb::ViewerPoses& poses) {
  wpb::ViewerPoses reported;
  for (const wpb::ViewerPose& pose : poses.poses()) {
    const bool is_reported = std::ranges::any_of(
        people_.people(), [&](const auto& person) { return person.id() == pose.viewer_id(); });
    if (!is_reported) continue;
    *reported.add_poses() = pose;
    poses_[pose.viewer_id()] = pose;
  }
  return reported;
}

wpb::ViewerPoses PresenceRelay::newest_poses() const {
  wpb::ViewerPoses all;
  for (const auto& [id, pose] : poses_) *all.add_poses() = pose;
  return all;
}

wpb::PeopleHere people_there(const wpb::Roster& roster, std::uint32_t own_viewer_id) {
  wpb::PeopleHere there;
  for (const wpb::ViewerEntry& person : roster.viewers()) {
    const bool is_us = person.id() == own_viewer_id || person.through() == own_viewer_id;
    if (is_us || person.relays()) continue;
    *there.add_people() = reportable(person);
  }
  return there;
}

}  // namespace roomcast::hub::federation
