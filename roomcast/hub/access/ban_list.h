// SPDX-License-Identifier: Apache-2.0
// BanList: bans addresses for a while if they present bad tokens repeatedly. Bounded: when too many
// addresses have records at once, older records are dropped. Threading: any thread.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <unordered_map>

#include "roomcast/core/clock.h"

namespace roomcast::hub {

struct BanRules {
  std::size_t faults = 10;  // so many bad tokens ...
  std::chrono::seconds within{60};
  std::chrono::seconds ban{300};
  std::size_t max_peers = 10'000;  // addresses with a record
};

class BanList {
 public:
  explicit BanList(BanRules rules = {}) : rules_(rules) {}

  /// Counts a bad token. True: the address is banned from now on.
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
