// SPDX-License-Identifier: Apache-2.0
// Attack: somebody who wants to be a burden to a hub on 127.0.0.1, from many addresses of this
// machine (127.0.0.0/8), at the lowest priority: an attacker's own work is not the hub's.
// Threading: a thread of its own until it is destroyed.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace roomcast::bench {

enum class AttackKind {
  kHalfOpen,   // connects and says nothing
  kGarbage,    // connects, says what is nothing, and goes on
  kSlowloris,  // a request header, a letter at a time
  kBadTokens,  // joins with tokens that are none, as often as it can
};

[[nodiscard]] std::string_view name_of(AttackKind kind);

class Attack {
 public:
  /// `connections`: held open at once; of bad tokens: tried in all.
  Attack(AttackKind kind, std::uint16_t port, int connections);

  struct Counts {
    std::uint64_t tried = 0;   // connections
    std::uint64_t served = 0;  // looks at which one was open; of bad tokens: that were answered
  };
  [[nodiscard]] Counts counts() const { return {tried_, served_}; }
  /// All bad tokens were shown; other attacks go on.
  [[nodiscard]] bool is_over() const { return over_; }

 private:
  void hold(const std::stop_token& stop, std::string_view first, std::string_view drip);
  void show_tokens(const std::stop_token& stop);
  [[nodiscard]] int connect();

  const AttackKind kind_;
  const std::uint16_t port_;
  const int connections_;
  std::atomic<std::uint64_t> tried_ = 0, served_ = 0;
  std::atomic<bool> over_ = false;
  std::jthread thread_;  // last: uses all of the above
};

}  // namespace roomcast::bench
