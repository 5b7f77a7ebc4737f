// SPDX-License-Identifier: Apache-2.0
// TrafficMeter: growth rates of counters that are sampled about once a second. Pure;
// single-threaded.
#pragma once

#include <chrono>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "roomcast/core/clock.h"

namespace roomcast::hub {

/// One counter and its growth rate between the last two samples.
class Growth {
 public:
  void sample(std::uint64_t count, HostTime now) {
    if (seen_ && now > at_) {
      const double passed_s = std::chrono::duration<double>(now - at_).count();
      per_s_ = count < count_ ? 0 : static_cast<double>(count - count_) / passed_s;
    }
    seen_ = true;
    count_ = count;
    at_ = now;
  }
  [[nodiscard]] double per_s() const { return per_s_; }

 private:
  bool seen_ = false;
  std::uint64_t count_ = 0;
  HostTime at_{};
  double per_s_ = 0;
};

/// Growth rates by key. forget_before() drops those that were not sampled for a while.
template <class Key>
class TrafficMeter {
 public:
  void sample(const Key& key, std::uint64_t count, HostTime now) {
    Entry& entry = entries_[key];
    entry.growth.sample(count, now);
    entry.sampled_at = now;
  }
  [[nodiscard]] double per_s(const Key& key) const {
    const auto found = entries_.find(key);
    return found == entries_.end() ? 0 : found->second.growth.per_s();
  }
  void forget_before(HostTime time) {
    std::erase_if(entries_, [time](const auto& entry) { return entry.second.sampled_at < time; });
  }

 private:
  struct Entry {
    Growth growth;
    HostTime sampled_at{};
  };
  std::unordered_map<Key, Entry> entries_;
};

}  // namespace roomcast::hub
