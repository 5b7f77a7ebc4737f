// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/ban_list.h"

#include <algorithm>

namespace roomcast::hub {

bool BanList::fault(const std::string& peer, HostTime now) {
  if (rules_.faults == 0) return false;
  const std::scoped_lock lock(mutex_);
  if (records_.size() >= rules_.max_peers && !records_.contains(peer)) forget_the_old(now);
  Record& record = records_[peer];
  if (record.faults == 0 || now - record.first > rules_.within)
    record = {.faults = 0, .first = now};
  if (++record.faults < rules_.faults) return false;
  record.faults = 0;
  record.banned_until = now + rules_.ban;
  return true;
}

bool BanList::is_banned(const std::string& peer, HostTime now) const {
  const std::scoped_lock lock(mutex_);
  const auto found = records_.find(peer);
  return found != records_.end() && now < found->second.banned_until;
}

std::size_t BanList::banned_count(HostTime now) const {
  const std::scoped_lock lock(mutex_);
  return static_cast<std::size_t>(std::ranges::count_if(
      records_, [now](const auto& entry) { return now < entry.second.banned_until; }));
}

/// Removes the records that no longer matter; if there are none, all records, so that memory stays
/// bounded.
void BanList::forget_the_old(HostTime now) {
  std::erase_if(records_, [&](const auto& entry) {
    return now >= entry.second.banned_until && now - entry.second.first > rules_.within;
  });
  if (records_.size() >= rules_.max_peers) records_.clear();
}

}  // namespace roomcast::hub
