// SPDX-License-Identifier: Apache-2.0
// HubChoice: which of several hubs a client connects to. It stays where it is; when that hub is
// gone the next one is tried at once, and only when all have failed in a row it waits. To those
// that it was given come those that its hub names. Pure.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "roomcast/core/retry_pace.h"
#include "roomcast/net/hub_url.h"

namespace roomcast {

class HubChoice {
 public:
  /// At least one; the first is tried first.
  HubChoice(std::vector<net::HubUrl> named, std::uint32_t seed);

  [[nodiscard]] const net::HubUrl& current() const { return hubs_[current_]; }
  [[nodiscard]] bool has_others() const { return hubs_.size() > 1; }

  /// Other hubs that have the room now, as the current one says; what it said before is forgotten.
  /// Not an address: left out.
  void learn(const std::vector<std::string>& urls);
  void welcomed() { failures_ = 0; }
  /// It went well for a while.
  void settled() { pace_.succeeded(); }
  /// The current one is gone, or never was there. How long to wait before trying the next, which
  /// is current now.
  [[nodiscard]] std::chrono::nanoseconds failed();

 private:
  const std::vector<net::HubUrl> named_;
  std::vector<net::HubUrl> hubs_;
  std::size_t current_ = 0;
  std::size_t failures_ = 0;  // in a row
  RetryPace pace_;
};

}  // namespace roomcast
