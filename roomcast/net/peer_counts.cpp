// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/peer_counts.h"

#include <algorithm>
#include <utility>

namespace roomcast::net {

PeerCounts::Place::Place(std::shared_ptr<std::atomic<std::size_t>> count)
    : count_(std::move(count)) {
  ++*count_;
}

PeerCounts::Place::~Place() {
  --*count_;
}

std::shared_ptr<PeerCounts::Place> PeerCounts::enter(const std::string& address,
                                                     std::size_t limit) {
  if (counts_.size() >= forget_at_) remove_unused();
  auto& count = counts_[address];
  if (count == nullptr) count = std::make_shared<std::atomic<std::size_t>>(0);
  if (*count >= limit) return nullptr;
  return std::make_shared<Place>(count);
}

/// The remaining entries are no more than the open connections, so the map's size is bounded by
/// twice that number (at least 1024).
void PeerCounts::remove_unused() {
  std::erase_if(counts_, [](const auto& entry) { return *entry.second == 0; });
  forget_at_ = std::max<std::size_t>(1024, 2 * counts_.size());
}

}  // namespace roomcast::net
