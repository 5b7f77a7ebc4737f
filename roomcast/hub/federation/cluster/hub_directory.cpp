// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/cluster/hub_directory.h"

#include <algorithm>
#include <utility>

#include "roomcast/wire/limits.h"

namespace roomcast::hub::federation {
namespace {

HostTime host_time(std::uint64_t ns) {
  return HostTime(nanoseconds(static_cast<std::int64_t>(ns)));
}

std::uint64_t ns_of(HostTime time) {
  return static_cast<std::uint64_t>(time.time_since_epoch().count());
}

bool is_public(const OtherHub& hub) {
  const std::string& url = hub.newest.public_url();
  return !url.empty() && url.size() <= wire::kMaxUrlBytes;
}

}  // namespace

std::optional<float> busy_share(const pb::Heartbeat& hub) {
  if (!(hub.load() >= 0 && hub.cores() > 0)) return std::nullopt;  // the negation covers NaN
  return hub.load() / hub.cores();
}

bool HubDirectory::update(const pb::Heartbeat& heartbeat, HostTime now) {
  const HubId id{heartbeat.hub()};
  if (id == own_ || id.value == 0) return false;
  const bool is_known = others_.contains(id);
  if (!is_known && (others_.size() >= kMaxHubs || heartbeat.leaves())) return false;
  OtherHub& hub = others_[id];
  update_clock(hub, heartbeat, now);
  hub.newest = heartbeat;
  if (heartbeat.all_rooms_size() > 0) {
    hub.rooms = {heartbeat.all_rooms().begin(), heartbeat.all_rooms().end()};
  }
  hub.received = now;
  return true;
}

void HubDirectory::update_clock(OtherHub& hub, const pb::Heartbeat& heartbeat, HostTime now) const {
  for (const pb::Heard& heard : heartbeat.heard()) {
    if (HubId{heard.hub()} != own_) continue;
    const HostTime sent = host_time(heard.sent_ns());
    const nanoseconds held_there = host_time(heartbeat.sent_ns()) - host_time(heard.received_ns());
    const RoomTime theirs(host_time(heartbeat.sent_ns()).time_since_epoch());
    if (held_there >= nanoseconds(0)) hub.clock.add(sent + held_there, theirs, now);
  }
}

std::vector<HubId> HubDirectory::remove_gone(HostTime now) {
  std::vector<HubId> gone;
  std::erase_if(others_, [&](const auto& entry) {
    const auto& [id, hub] = entry;
    const bool is_gone = hub.newest.leaves() || now - hub.received > kGoneAfter;
    if (is_gone) gone.push_back(id);
    return is_gone;
  });
  return gone;
}

void HubDirectory::write_heard(pb::Heartbeat& own) const {
  for (const auto& [id, hub] : others_) {
    pb::Heard& heard = *own.add_heard();
    heard.set_hub(id.value);
    heard.set_sent_ns(hub.newest.sent_ns());
    heard.set_received_ns(ns_of(hub.received));
  }
}

const OtherHub* HubDirectory::find(HubId hub) const {
  const auto found = others_.find(hub);
  return found == others_.end() ? nullptr : &found->second;
}

std::vector<std::string> HubDirectory::urls_with(const std::string& room) const {
  return urls_of([&room](const OtherHub& hub) { return hub.rooms.contains(room); });
}

std::vector<std::string> HubDirectory::less_busy_with(const std::string& room,
                                                      const pb::Heartbeat& own) const {
  const auto here = busy_share(own);
  std::vector<std::pair<float, std::string>> less;
  for (const auto& [id, hub] : others_) {
    const auto there = busy_share(hub.newest);
    if (!here || !there || *there > *here / 2 || !is_public(hub) || !hub.rooms.contains(room)) {
      continue;
    }
    less.emplace_back(*there, hub.newest.public_url());
  }
  std::ranges::sort(less);
  std::vector<std::string> urls;
  for (auto& [share, url] : less) {
    if (urls.size() < wire::kMaxOtherHubs) urls.push_back(std::move(url));
  }
  return urls;
}

std::vector<std::string> HubDirectory::urls() const {
  return urls_of([](const OtherHub&) { return true; });
}

std::vector<std::string> HubDirectory::urls_of(
    const std::function<bool(const OtherHub&)>& matches) const {
  std::vector<std::string> urls;
  for (const auto& [id, hub] : others_) {
    if (is_public(hub) && matches(hub)) urls.push_back(hub.newest.public_url());
  }
  std::ranges::sort(urls);
  if (urls.size() > wire::kMaxOtherHubs) urls.resize(wire::kMaxOtherHubs);
  return urls;
}

bool HubDirectory::is_wanted(std::string_view room) const {
  return std::ranges::any_of(others_, [room](const auto& entry) {
    const pb::RoomHere* here = room_of(entry.second.newest, room);
    return here != nullptr && here->wants_frames();
  });
}

const pb::RoomHere* room_of(const pb::Heartbeat& heartbeat, std::string_view room) {
  const auto found = std::ranges::find_if(
      heartbeat.rooms(), [room](const pb::RoomHere& here) { return here.room() == room; });
  return found == heartbeat.rooms().end() ? nullptr : &*found;
}

std::optional<HubId> owner_of(std::string_view room, const pb::Heartbeat& own,
                              const HubDirectory& directory) {
  std::optional<std::pair<bool, HubId>> best;  // has no sensors, id
  const auto consider = [&](const pb::Heartbeat& hub) {
    const pb::RoomHere* here = room_of(hub, room);
    if (!hub.aligns() || here == nullptr || here->revision() == 0) return;
    const std::pair candidate(here->sensors() == 0, HubId{hub.hub()});
    if (!best || candidate < *best) best = candidate;
  };
  consider(own);
  for (const auto& [id, hub] : directory.others()) consider(hub.newest);
  return best ? std::optional(best->second) : std::nullopt;
}

}  // namespace roomcast::hub::federation
