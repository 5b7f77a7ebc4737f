// SPDX-License-Identifier: Apache-2.0
// HubChoice: at which of several hubs a client is. It knocks at all of them and stays at the one
// that answers first: the nearest, unless that one is so busy that it takes longer to answer than
// one farther away (who knocks at a hub is served after who is inside). It stays where it is; when
// that hub is gone, or has refused it, it knocks at the others at once, and only when all have
// failed in a row it waits. To those that it was given come those that its hub names. Pure.
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

  /// Where to knock now, all at once.
  [[nodiscard]] std::vector<net::HubUrl> to_try() const;
  /// The one that answered last; at first the first one named.
  [[nodiscard]] const net::HubUrl& current() const { return hubs_[current_]; }
  [[nodiscard]] bool has_others() const { return hubs_.size() > 1; }

  /// Other hubs that have the room now, as the current one says; what it said before is forgotten.
  /// Not an address: left out.
  void learn(const std::vector<std::string>& urls);
  /// This one did so first, of those to try.
  void answered(const net::HubUrl& hub);
  void welcomed() { failures_ = 0; }
  /// It went well for a while.
  void settled() { pace_.succeeded(); }
  /// The current one is gone, or has sent us away. How long to wait before knocking again, at the
  /// others if there are any.
  [[nodiscard]] std::chrono::nanoseconds failed();
  /// None did. How long to wait before knocking again, at all.
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
