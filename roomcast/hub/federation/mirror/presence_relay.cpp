// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/mirror/presence_relay.h"

#include <algorithm>
#include <utility>

#include "roomcast/wire/limits.h"

namespace roomcast::hub::federation {
namespace {

namespace pb = wire::pb;

pb::ViewerEntry told_of(const pb::ViewerEntry& person) {
  pb::ViewerEntry told = person;
  told.clear_through();  // an ID that is meaningless on another hub
  return told;
}

bool comes_from_backplane(const pb::ViewerEntry& person) {
  return person.hubs_away() > 0 && person.through() == 0;
}

}  // namespace

bool PresenceRelay::take(const pb::Roster& roster) {
  std::map<std::uint32_t, pb::ViewerEntry> people;  // sorted by ID: a roster is unordered
  for (const pb::ViewerEntry& person : roster.viewers()) {
    if (person.relays() || comes_from_backplane(person)) continue;
    people[person.id()] = told_of(person);
  }
  pb::PeopleHere now;
  for (auto& [id, person] : people) {
    if (now.people_size() < wire::kMaxPeopleHere) *now.add_people() = std::move(person);
  }
  std::erase_if(poses_, [&](const auto& pose) { return !people.contains(pose.first); });
  const bool is_news = now.SerializeAsString() != people_.SerializeAsString();
  people_ = std::move(now);
  return is_news;
}

pb::ViewerPoses PresenceRelay::take(const pb::ViewerPoses& poses) {
  pb::ViewerPoses told;
  for (const pb::ViewerPose& pose : poses.poses()) {
    const bool is_theirs = std::ranges::any_of(
        people_.people(), [&](const auto& person) { return person.id() == pose.viewer_id(); });
    if (!is_theirs) continue;
    *told.add_poses() = pose;
    poses_[pose.viewer_id()] = pose;
  }
  return told;
}

pb::ViewerPoses PresenceRelay::newest_poses() const {
  pb::ViewerPoses all;
  for (const auto& [id, pose] : poses_) *all.add_poses() = pose;
  return all;
}

pb::PeopleHere people_there(const pb::Roster& roster, std::uint32_t own_viewer_id) {
  pb::PeopleHere there;
  for (const pb::ViewerEntry& person : roster.viewers()) {
    const bool is_us = person.id() == own_viewer_id || person.through() == own_viewer_id;
    if (is_us || person.relays()) continue;
    *there.add_people() = told_of(person);
  }
  return there;
}

}  // namespace roomcast::hub::federation
