// SPDX-License-Identifier: Apache-2.0
// The result of alignment, with errors and reasons. Millimetres where a name says so, metres
// elsewhere. Plain data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomcast/alignment/pair/sensor_correction.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

struct PairReport {
  std::string a, b;
  bool accepted = false;
  std::optional<RigidTransform> b_from_a;
  double overlap = 0;  // shared part of the surface, the smaller of both sensors' shares
  int inliers = 0;     // places in space (5 cm cells) where features of both agree
  // residual_mm and expected_error_mm are 0 where there is no pose.
  double residual_mm = 0;        // median distance between the surfaces that both see
  double expected_error_mm = 0;  // standard deviation of the relative pose, 2.5 m ahead of b, as if
                                 // both sensors' errors were independent
  double conflict = 0;           // share of judged points that contradicts the pose
  double correlation = 0;        // of the colours on common surfaces
  double margin = 0;             // score difference to the best rival
  std::string reason;            // one sentence: why it was accepted, or what would help
};

struct SensorReport {
  std::string id;
  bool placed = false;
  std::optional<RigidTransform> world_from_depth;  // of placed sensors only
  // One standard deviation; 0 for the origin. Without the error of the room's scale.
  double expected_error_mm = 0;   // of surfaces 2.5 m ahead
  double expected_error_deg = 0;  // of the direction
  SensorCorrection correction;    // estimated calibration error
  /// Factor on the sensor's readings, assumed by its pose; 1 where it is not determined.
  double depth_scale = 1;
  double depth_scale_standard_error = 0;  // relative to the origin's; 0 where it is not determined
  // Compared with other placed sensors:
  double overlap = 0;      // the largest of its pairs
  int inliers = 0;         // sum of its pairs
  double residual_mm = 0;  // mean of its pairs, weighted by overlap
  std::string reason;
};

struct AlignmentReport {
  std::vector<SensorReport> sensors;  // in the order given
  std::vector<PairReport> pairs;
  bool has_floor = false;
  double uncalibrated_belief = 0;  // 0..1: that placed sensors are not calibrated (ADR 18)
  /// One standard deviation by which all distances may be too long or too short alike, as a share;
  /// 0 where no two sensors are placed. Not part of the sensors' errors (common_scale.h).
  double scale_error = 0;
};

}  // namespace roomcast::alignment
