// SPDX-License-Identifier: Apache-2.0
// What alignment found out, and how sure it is. Millimetres where a name says so, metres elsewhere.
// Plain data.
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
  double overlap = 0;  // share of its surface that the sensor which shares less shares
  int inliers = 0;     // places in space (5 cm cells) where features of both agree
  // Only where there is a pose:
  double residual_mm = 0;        // median distance between the surfaces that both see
  double expected_error_mm = 0;  // one standard deviation of how they stand, 2.5 m ahead of b, as
                                 // if the errors of both had nothing in common
  double conflict = 0;           // share of what can be judged that contradicts the pose
  double correlation = 0;        // of the colours on common surfaces
  double margin = 0;             // by how much the answer is ahead of its best rival
  std::string reason;            // one sentence: why it was accepted, or what would help
};

struct SensorReport {
  std::string id;
  bool placed = false;
  std::optional<RigidTransform> world_from_depth;  // of placed sensors only
  // One standard deviation; 0 for the origin.
  double expected_error_mm = 0;   // of surfaces 2.5 m ahead
  double expected_error_deg = 0;  // of the direction
  SensorCorrection correction;    // what its calibration seems to be off by
  // Beside those that are placed, too:
  double overlap = 0;      // with the one it shares most with
  int inliers = 0;         // in all
  double residual_mm = 0;  // mean of its pairs, by overlap
  std::string reason;
};

struct AlignmentReport {
  std::vector<SensorReport> sensors;  // in the order given
  std::vector<PairReport> pairs;
  bool has_floor = false;
};

}  // namespace roomcast::alignment
