// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/remote_presence.h"

#include <utility>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

constexpr std::uint32_t kColorBits = 0xFFFFFF;

/// The person's entry in this room's roster. The colour stays that of the person's own hub.
pb::ViewerEntry entry_here(const pb::ViewerEntry& reported, ViewerId id, ViewerId reporter) {
  pb::ViewerEntry entry;
  entry.set_id(id.value);
  entry.set_name(reported.name());
  entry.set_color_rgb(reported.color_rgb() & kColorBits);
  entry.set_hubs_away(reported.hubs_away() + 1);
  entry.set_through(reporter.value);
  return entry;
}

bool is_the_same(const pb::ViewerEntry& a, const pb::ViewerEntry& b) {
  return a.name() == b.name() && a.color_rgb() == b.color_rgb() && a.hubs_away() == b.hubs_away();
}

}  // namespace

RemotePresence::Change RemotePresence::report(const Reporter& reporter,
                                              const pb::PeopleHere& people, const NewId& new_id) {
  People& now = reported_[reporter.connection];
  People before = std::exchange(now, {});
  Change change;
  const auto keep = [&](const pb::ViewerEntry& reported, ViewerId id) {
    return &(now[reported.id()] = entry_here(reported, id, reporter.viewer));
  };
  for (const pb::ViewerEntry& reported : people.people()) {
    const auto known = before.extract(reported.id());
    if (!known) continue;
    const auto* entry = keep(reported, ViewerId{known.mapped().id()});
    change.has_changed |= !is_the_same(known.mapped(), *entry);
  }
  for (const pb::ViewerEntry& reported : people.people()) {
    const bool is_too_far = reported.hubs_away() >= wire::kMaxHubsAway;
    if (is_too_far || now.contains(reported.id()) || count() >= wire::kMaxPeopleElsewhere) continue;
    keep(reported, new_id());
    change.has_changed = true;
  }
  for (const auto& [there, entry] : before) change.gone.push_back(ViewerId{entry.id()});
  change.has_changed |= !change.gone.empty();
  return change;
}

RemotePresence::Change RemotePresence::forget(ConnectionId reporter) {
  Change change;
  const auto reported = reported_.extract(reporter);
  if (!reported) return change;
  for (const auto& [there, entry] : reported.mapped()) change.gone.push_back(ViewerId{entry.id()});
  change.has_changed = !change.gone.empty();
  return change;
}

std::optional<ViewerId> RemotePresence::find(ConnectionId reporter, std::uint32_t id_there) const {
  const auto reported = reported_.find(reporter);
  if (reported == reported_.end()) return std::nullopt;
  const auto person = reported->second.find(id_there);
  if (person == reported->second.end()) return std::nullopt;
  return ViewerId{person->second.id()};
}

void RemotePresence::write_to(pb::Roster& roster) const {
  for (const auto& [reporter, people] : reported_) {
    for (const auto& [there, entry] : people) {
      if (roster.viewers_size() >= static_cast<int>(wire::kMaxViewers)) return;
      *roster.add_viewers() = entry;
    }
  }
}

std::size_t RemotePresence::count() const {
  std::size_t sum = 0;
  for (const auto& [reporter, people] : reported_) sum += people.size();
  return sum;
}

}  // namespace roomcast::hub
