// SPDX-License-Identifier: Apache-2.0
// HubChoice: selects one of several hubs. The client connects to all of them and stays at the one
// that answers first: the nearest, unless that one is so busy that its answer takes longer than
// that of a hub farther away (a hub serves new connections after established ones). The client
// stays there; if that hub fails or refuses it, it tries the others at once, and waits only after
// all have failed in a row. Hubs that the current hub names are added to the configured ones. No
// I/O.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/backoff.h"
#include "roomcast/net/hub_url.h"

namespace roomcast::client {

class HubChoice {
 public:
  /// At least one.
  HubChoice(std::vector<net::HubUrl> named, std::uint32_t seed);

  /// The hubs to connect to now, all at once.
  [[nodiscard]] std::vector<net::HubUrl> to_try() const;
  /// The hub that answered last; initially the first configured one.
  [[nodiscard]] const net::HubUrl& current() const { return hubs_[current_]; }
  [[nodiscard]] bool has_others() const { return hubs_.size() > 1; }

  /// Sets the other hubs of the room, as reported by the current one; they replace those reported
  /// before. Invalid addresses are omitted.
  void learn(const std::vector<std::string>& urls);
  /// This hub was the first of to_try() to answer.
  void answered(const net::HubUrl& hub);
  void welcomed() { failures_ = 0; }
  /// The connection was stable for a while.
  void settled() { pace_.succeeded(); }
  /// The current hub failed or refused the client. Returns the time to wait before the next
  /// attempt, which is at the others if there are any.
  [[nodiscard]] std::chrono::nanoseconds failed();
  /// No hub answered. Returns the time to wait before the next attempt at all hubs.
  [[nodiscard]] std::chrono::nanoseconds nobody_answered();

 private:
  const std::vector<net::HubUrl> named_;
  std::vector<net::HubUrl> hubs_;
  std::size_t current_ = 0;
  bool avoids_current_ = false;
  std::size_t failures_ = 0;  // in a row
  Backoff pace_;
};

}  // namespace roomcast::client
