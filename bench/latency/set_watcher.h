// SPDX-License-Identifier: Apache-2.0
// SetWatcher: a viewer that looks at nothing but the clock: how old every frame is when it comes,
// which frame sets come and whether whole, and how wrong its idea of room time is. The hub runs on
// this machine's clock, so both are exact. Threading: as TimedSensor.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace roomcast::bench {

struct Arrivals {
  std::vector<double> ages_ms;          // of all frames
  std::map<std::uint64_t, int> sets;    // by id: how many of its frames have come
  std::vector<double> clock_errors_us;  // of the estimate, after each exchange
};

class SetWatcher {
 public:
  explicit SetWatcher(const std::string& hub_url);
  ~SetWatcher();

  /// Frames have come.
  [[nodiscard]] bool sees_something() const;
  /// What has come since the last call.
  [[nodiscard]] Arrivals take();

 private:
  class Link;
  std::unique_ptr<Link> link_;
};

}  // namespace roomcast::bench
