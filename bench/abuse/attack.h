// SPDX-License-Identifier: Apache-2.0
// Attack: an attacker of a hub on 127.0.0.1. It uses many source addresses of 127.0.0.0/8 and runs
// at the lowest priority, because its own work is not part of the hub's cost.
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
  kHalfOpen,   // connects and sends nothing
  kGarbage,    // connects and keeps sending invalid bytes
  kSlowloris,  // sends a request header one character at a time
  kBadTokens,  // joins with invalid tokens as often as possible
};

[[nodiscard]] std::string_view name_of(AttackKind kind);

class Attack {
 public:
  /// `connections`: open at the same time; for bad tokens: the total number of attempts.
  Attack(AttackKind kind, std::uint16_t port, int connections);

  struct Counts {
    std::uint64_t tried = 0;  // connections
    /// Checks that found a connection open; for bad tokens: answered connections.
    std::uint64_t served = 0;
  };
  [[nodiscard]] Counts counts() const { return {tried_, served_}; }
  /// True once all bad tokens were sent; other attacks run until destruction.
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
  std::jthread thread_;  // last: uses all members above
};

}  // namespace roomcast::bench
