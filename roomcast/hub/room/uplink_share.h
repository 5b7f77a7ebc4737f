// SPDX-License-Identifier: Apache-2.0
// UplinkShare: divides a room's uplink among its sensors by what viewers look at. A sensor that
// comes into view gets its share at once; what goes out of view loses it slowly, so that shares do
// not swing with a viewer who looks to and fro. Sensors that do not keep to a share keep their
// rate, and the others share the rest. A calm sensor lends what it does not use of its share to
// those that use all of theirs, and has it back at once when it uses all that it was left.
// Pure; single-threaded. Source of the division: max-min fairness (Bertsekas and Gallager 1992).
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"

namespace roomcast::hub {

/// A sensor that is online.
struct UplinkUser {
  SensorId sensor;
  double importance = 1;         // share of the viewers who see it; of base layers only, less
  bool is_paused = false;        // it sends no frames
  bool follows = true;           // it keeps to a share
  double most_mbit = 0;          // it was started with; 0: none
  std::uint64_t sent_bytes = 0;  // of its frames so far
};

class UplinkShare {
 public:
  /// Between two looks while nothing happens.
  static constexpr std::chrono::milliseconds kInterval{500};
  /// The least that a sensor is given, also where the uplink is too small for all.
  static constexpr double kMinShare_mbit = 0.1;

  /// Divides `uplink_mbit`; 0: there is no limit, and every share is 0. Call whenever something has
  /// changed, and at next().
  void update(double uplink_mbit, std::span<const UplinkUser> users, RoomTime now);

  /// Mbit/s on the line, with headers of TCP and IP; 0: as it likes.
  [[nodiscard]] double of(SensorId sensor) const;
  [[nodiscard]] std::optional<RoomTime> next() const { return next_; }

 private:
  struct Known {
    double weight = 0;
    RoomTime reached{};  // the weight, last
    double mbit = 0;     // its share as it was last given
    bool is_paused = false;
    std::uint64_t sent_bytes = 0;
    std::optional<double> sends_mbit = {};  // measured
    RoomTime used_all{};                    // its share, last
    bool lends = false;                     // it leaves a part of its share to others
  };
  void forget_absent(std::span<const UplinkUser> users);
  void measure(std::span<const UplinkUser> users, double seconds);
  void find_lenders(std::span<const UplinkUser> users, RoomTime now);
  [[nodiscard]] std::vector<double> divide(double uplink_mbit,
                                           std::span<const UplinkUser> users) const;
  [[nodiscard]] static std::vector<double> lend(double mbit,
                                                const std::vector<const Known*>& sharing,
                                                const std::vector<double>& weights,
                                                const std::vector<double>& most);

  std::map<SensorId, Known> known_;
  double uplink_mbit_ = 0;
  std::optional<RoomTime> updated_, next_;
};

/// Divides `mbit` in proportion to `weights`, but gives nobody less than `least`, nor more than its
/// entry in `most` (0: no limit).
[[nodiscard]] std::vector<double> divide_rate(double mbit, const std::vector<double>& weights,
                                              double least, const std::vector<double>& most);

}  // namespace roomcast::hub
