// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/remote_presence.h"

#include <utility>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

constexpr std::uint32_t kColorBits = 0xFFFFFF;

/// The person's entry in this room's roster. The colour stays that of the person's own hub.
pb::ViewerEntry entry_here(const pb::ViewerEntry& told, ViewerId id, ViewerId teller) {
  pb::ViewerEntry entry;
  entry.set_id(id.value);
  entry.set_name(told.name());
  entry.set_color_rgb(told.color_rgb() & kColorBits);
  entry.set_hubs_away(told.hubs_away() + 1);
  entry.set_through(teller.value);
  return entry;
}

bool is_the_same(const pb::ViewerEntry& a, const pb::ViewerEntry& b) {
  return a.name() == b.name() && a.color_rgb() == b.color_rgb() && a.hubs_away() == b.hubs_away();
}

}  // namespace

RemotePresence::Change RemotePresence::tell(const Teller& teller, const pb::PeopleHere& people,
                                            const NewId& new_id) {
  People& now = told_[teller.connection];
  People before = std::exchange(now, {});
  Change change;
  const auto keep = [&](const pb::ViewerEntry& told, ViewerId id) {
    return &(now[told.id()] = entry_here(told, id, teller.viewer));
  };
  for (const pb::ViewerEntry& told : people.people()) {
    const auto known = before.extract(told.id());
    if (!known) continue;
    const auto* entry = keep(told, ViewerId{known.mapped().id()});
    change.is_news |= !is_the_same(known.mapped(), *entry);
  }
  for (const pb::ViewerEntry& told : people.people()) {
    const bool is_too_far = told.hubs_away() >= wire::kMaxHubsAway;
    if (is_too_far || now.contains(told.id()) || count() >= wire::kMaxPeopleElsewhere) continue;
    keep(told, new_id());
    change.is_news = true;
  }
  for (const auto& [there, entry] : before) change.gone.push_back(ViewerId{entry.id()});
  change.is_news |= !change.gone.empty();
  return change;
}

RemotePresence::Change RemotePresence::forget(ConnectionId teller) {
  Change change;
  const auto told = told_.extract(teller);
  if (!told) return change;
  for (const auto& [there, entry] : told.mapped()) change.gone.push_back(ViewerId{entry.id()});
  change.is_news = !change.gone.empty();
  return change;
}

std::optional<ViewerId> RemotePresence::find(ConnectionId teller, std::uint32_t id_there) const {
  const auto told = told_.find(teller);
  if (told == told_.end()) return std::nullopt;
  const auto person = told->second.find(id_there);
  if (person == told->second.end()) return std::nullopt;
  return ViewerId{person->second.id()};
}

void RemotePresence::write_to(pb::Roster& roster) const {
  for (const auto& [teller, people] : told_) {
    for (const auto& [there, entry] : people) {
      if (roster.viewers_size() >= static_cast<int>(wire::kMaxViewers)) return;
      *roster.add_viewers() = entry;
    }
  }
}

std::size_t RemotePresence::count() const {
  std::size_t sum = 0;
  for (const auto& [teller, people] : told_) sum += people.size();
  return sum;
}

}  // namespace roomcast::hub
