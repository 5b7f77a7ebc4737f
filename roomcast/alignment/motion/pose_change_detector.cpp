// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/motion/pose_change_detector.h"

namespace roomcast::alignment {
namespace {

bool moved_a_little(const MotionEvidence& evidence, const PoseChangeOptions& options) {
  return (evidence.shift_m > options.min_shift_m || evidence.angle_rad > options.min_turn_rad) &&
         evidence.agree_if_moved > options.min_agreement && evidence.gain > options.min_gain;
}

bool moved_far(const MotionEvidence& evidence, const PoseChangeOptions& options) {
  return evidence.gone > options.max_gone && evidence.agree_if_still < options.hardly_agrees;
}

}  // namespace

std::optional<bool> indicates_motion(const MotionEvidence& evidence,
                                     const PoseChangeOptions& options) {
  if (moved_far(evidence, options)) return true;
  if (evidence.comparable < options.min_comparable) return std::nullopt;
  return moved_a_little(evidence, options);
}

bool PoseChangeDetector::moved(DepthView depth_mm, HostTime time) {
  if (!last_look_ || time - *last_look_ >= options_.check_interval) {
    last_look_ = time;
    const auto says = indicates_motion(check_.compare(depth_mm), options_);
    blind_in_a_row_ = says ? 0 : blind_in_a_row_ + 1;
    if (says) in_a_row_ = *says ? in_a_row_ + 1 : 0;
  }
  return in_a_row_ >= options_.agreeing_checks || blind_in_a_row_ >= options_.blind_checks;
}

}  // namespace roomcast::alignment
