// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/motion/pose_change_detector.h"

namespace roomcast::alignment {
namespace {

constexpr double kMinShift_m = 0.014, kMinAngle_rad = 0.0058;  // 0.33 degrees
constexpr double kMinAgreement = 0.6;                          // most of the room
constexpr double kMinGain =
    0.03;  // of misfit, in squared sigmas; below this the old pose fits equally well
constexpr double kMinComparable = 0.2;                  // less is inconclusive
constexpr double kMaxGone = 0.25, kHardlyAgrees = 0.3;  // the sensor was turned away completely

bool moved_a_little(const MotionEvidence& evidence) {
  return (evidence.shift_m > kMinShift_m || evidence.angle_rad > kMinAngle_rad) &&
         evidence.agree_if_moved > kMinAgreement && evidence.gain > kMinGain;
}

bool moved_far(const MotionEvidence& evidence) {
  return evidence.gone > kMaxGone && evidence.agree_if_still < kHardlyAgrees;
}

}  // namespace

std::optional<bool> indicates_motion(const MotionEvidence& evidence) {
  if (moved_far(evidence)) return true;
  if (evidence.comparable < kMinComparable) return std::nullopt;
  return moved_a_little(evidence);
}

bool PoseChangeDetector::moved(DepthView depth_mm, HostTime time) {
  if (!last_look_ || time - *last_look_ >= kCheckInterval) {
    last_look_ = time;
    const auto says = indicates_motion(check_.compare(depth_mm));
    blind_in_a_row_ = says ? 0 : blind_in_a_row_ + 1;
    if (says) in_a_row_ = *says ? in_a_row_ + 1 : 0;
  }
  return in_a_row_ >= kAgreeingChecks || blind_in_a_row_ >= kBlindChecks;
}

}  // namespace roomcast::alignment
