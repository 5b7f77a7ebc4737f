// SPDX-License-Identifier: Apache-2.0
// PoseChangeDetector: detects within 2 s that its sensor was moved by at least 2 cm or half a
// degree. People who walk past and chairs that are pushed do not trigger it: it checks a picture
// every 400 ms, and reports a motion only if most of the room agrees in several consecutive checks.
// Single-threaded.
#pragma once

#include <optional>

#include "roomcast/alignment/motion/motion_check.h"
#include "roomcast/core/clock.h"

namespace roomcast::alignment {

/// Time between two checks.
inline constexpr std::chrono::milliseconds kCheckInterval{400};
/// Consecutive checks that must agree.
inline constexpr int kAgreeingChecks = 3;

/// After this many consecutive checks in which the background is hidden, the cause is not a person
/// in front of the sensor: the sensor was turned towards a near object.
inline constexpr int kBlindChecks = 25;

/// A little further than noise and less than 2 cm or half a degree, as chosen on recordings and
/// simulated rooms (docs/benchmarks/live-alignment.md), unless noted.
struct PoseChangeOptions {
  MotionCheckOptions check_picture;
  double min_shift_m = 0.014, min_turn_rad = 0.0058;  // 0.33 degrees
  double min_agreement = 0.6;   // share of the surface that fits the new pose: most of the room
  double min_gain = 0.03;       // of misfit, in squared sigmas; with less the old pose fits as well
  double min_comparable = 0.2;  // share of the surface; less is inconclusive
  /// More of the surface gone, and less in agreement: the sensor was turned away completely.
  double max_gone = 0.25, hardly_agrees = 0.3;
  std::chrono::milliseconds check_interval = kCheckInterval;  // for detection within 2 s
  int agreeing_checks = kAgreeingChecks;
  int blind_checks = kBlindChecks;  // 10 s: longer than a person stands in front of a sensor

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("check_picture", check_picture);
    visit("min_shift_m", min_shift_m, Range{0, 10});
    visit("min_turn_rad", min_turn_rad, Range{0, 3.2});
    visit("min_agreement", min_agreement, Range{0, 1});
    visit("min_gain", min_gain, Range{0, 1000});
    visit("min_comparable", min_comparable, Range{0, 1});
    visit("max_gone", max_gone, Range{0, 1});
    visit("hardly_agrees", hardly_agrees, Range{0, 1});
    visit("check_interval_ms", check_interval, Range{0, 1e6});
    visit("agreeing_checks", agreeing_checks, Range{1, 1000});
    visit("blind_checks", blind_checks, Range{1, 100000});
  }
  [[nodiscard]] Status check() const { return check_fields("PoseChangeOptions", *this); }
};

/// Whether this picture alone indicates that the sensor has moved; nothing if it is inconclusive,
/// as when a person is close in front of the sensor.
[[nodiscard]] std::optional<bool> indicates_motion(const MotionEvidence& evidence,
                                                   const PoseChangeOptions& options = {});

class PoseChangeDetector {
 public:
  /// `bundle` has passed check().
  explicit PoseChangeDetector(const CalibrationBundle& bundle,
                              const PoseChangeOptions& options = {})
      : options_(options), check_(bundle, options.check_picture) {}

  /// `depth_mm` has the bundle's size and was taken at `time`. Returns true if the sensor has
  /// moved. Most pictures are skipped.
  [[nodiscard]] bool moved(DepthView depth_mm, HostTime time);

 private:
  PoseChangeOptions options_;
  MotionCheck check_;
  std::optional<HostTime> last_look_;
  int in_a_row_ = 0;
  int blind_in_a_row_ = 0;
};

}  // namespace roomcast::alignment
