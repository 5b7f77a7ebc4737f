// SPDX-License-Identifier: Apache-2.0
// SetWatcher: a viewer that does not decode. It measures the age of every frame on arrival, the
// completeness of frame sets, and the error of its room time estimate. The hub runs on this
// machine's clock, so ages and clock errors are exact. Threading: as TimedSensor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace roomcast::bench {

struct Arrivals {
  std::vector<double> ages_ms;                            // of all frames
  std::size_t small_frames = 0;                           // of these, those of small renditions
  std::map<std::uint16_t, std::vector<double>> times_ms;  // by sensor, since the clock's beginning
  std::map<std::uint64_t, int> sets;    // number of frames that arrived, by set id
  std::vector<double> clock_errors_us;  // of the estimate, after each exchange
};

class SetWatcher {
 public:
  explicit SetWatcher(const std::string& hub_url);
  ~SetWatcher();

  /// True once frames have arrived.
  [[nodiscard]] bool sees_something() const;
  /// Everything that arrived since the last call.
  [[nodiscard]] Arrivals take();

 private:
  class Link;
  std::unique_ptr<Link> link_;
};

}  // namespace roomcast::bench
