// SPDX-License-Identifier: Apache-2.0
// BanList: whoever shows bad tokens again and again is not listened to for a while. Bounded: when
// too many addresses misbehave at once, the oldest faults are forgotten. Any thread.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <unordered_map>

#include "roomcast/core/clock.h"

namespace roomcast::hub {

struct BanRules {
  std::size_t faults = 10;  // bad tokens...
  std::chrono::seconds within{60};
  std::chrono::seconds ban{300};
  std::size_t max_peers = 10'000;  // that are remembered
};

class BanList {
 public:
  explicit BanList(BanRules rules = {}) : rules_(rules) {}

  /// True: this one is banned from now on.
  bool fault(const std::string& peer, HostTime now);
  [[nodiscard]] bool is_banned(const std::string& peer, HostTime now) const;
  [[nodiscard]] std::size_t banned_count(HostTime now) const;

 private:
  struct Record {
    std::size_t faults = 0;
    HostTime first{};
    HostTime banned_until{};
  };
  void forget_the_old(HostTime now);

  const BanRules rules_;
  mutable std::mutex mutex_;
  std::unordered_map<std::string, Record> records_;
};

}  // namespace roomcast::hub
