// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/watch_party.h"

#include <algorithm>
#include <utility>

namespace roomcast::hub {

namespace {

double position_at(const Playing& playing, HostTime since, HostTime now) {
  if (playing.paused) return playing.position_s;
  return playing.position_s + playing.speed * std::chrono::duration<double>(now - since).count();
}

}  // namespace

void WatchParties::forget_gone(HostTime now) {
  for (auto& [recording, party] : parties_) {
    std::erase_if(party.watchers,
                  [now](const Watcher& watcher) { return now - watcher.seen > kGoneAfter; });
  }
  std::erase_if(parties_, [](const auto& entry) { return entry.second.watchers.empty(); });
}

std::optional<WatchParties::View> WatchParties::visit(const std::string& recording,
                                                      WatcherState watcher, HostTime now) {
  if (const auto party = parties_.find(recording); watcher.leaves && party != parties_.end()) {
    std::erase_if(party->second.watchers,
                  [&](const Watcher& known) { return known.state.key == watcher.key; });
  }
  forget_gone(now);
  if (watcher.leaves) return View{};
  if (!parties_.contains(recording) && parties_.size() == kMaxParties) return std::nullopt;
  Party& party = parties_[recording];
  auto own =
      std::ranges::find(party.watchers, watcher.key,
                        [](const Watcher& known) -> const std::string& { return known.state.key; });
  if (own == party.watchers.end()) {
    if (party.watchers.size() == kMaxWatchers) return std::nullopt;
    own = party.watchers.insert(own, Watcher{.state = {}, .id = next_id_++});
  }
  own->seen = now;
  const auto wants = std::exchange(watcher.wants, std::nullopt);
  own->state = std::move(watcher);
  if (wants) {
    party.playing = *wants;
    party.since = now;
    ++party.change;
    party.changed_by = own->id;
    party.by = own->state.name;
  }
  View view{.others = {}, .playing = party.playing, .change = party.change, .by = party.by};
  view.playing.position_s = position_at(party.playing, party.since, now);
  view.is_own = party.changed_by == own->id;
  for (const Watcher& other : party.watchers) {
    if (other.id == own->id) continue;
    view.others.push_back({other.id, other.state.viewer, other.state.name, other.state.head});
  }
  return view;
}

}  // namespace roomcast::hub
