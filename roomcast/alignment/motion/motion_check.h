// SPDX-License-Identifier: Apache-2.0
// MotionCheck: has the sensor itself moved since its calibration bundle? Compares one depth picture
// with the bundle's: projective point-to-plane ICP (Blais & Levine 1995; Chen & Medioni 1992) with
// depth-noise weights, from no motion on, under a robust kernel that narrows from step to step
// (graduated non-convexity, Blake & Zisserman 1987). People and things that move are a minority
// that the kernel leaves out; what is hidden behind somebody is not counted at all. Directions that
// this view cannot tell (along a bare wall) count as still. About a millisecond of CPU per picture.
// Metres, radians. Thread-safe (immutable).
#pragma once

#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/bundle/calibration_bundle.h"
#include "roomcast/alignment/view/lens.h"

namespace roomcast::alignment {

/// What one picture says. Shares are of the bundle's surface points that can be compared.
struct MotionEvidence {
  RigidTransform now_from_then;
  double shift_m = 0, angle_rad = 0;
  double comparable = 0;      // share of all points: with a reading that nobody stands before
  double agree_if_still = 0;  // share that fits if the sensor has not moved
  double agree_if_moved = 0;  // share that fits if it has moved by now_from_then
  double gain = 0;            // by how much moving makes the mean misfit smaller, in squared sigmas
  double gone = 0;            // share of all points with readings: seen through if it is still
};

class MotionCheck {
 public:
  /// `bundle` has passed check().
  explicit MotionCheck(const CalibrationBundle& bundle);

  /// `depth_mm` has the size of the bundle's.
  [[nodiscard]] MotionEvidence compare(DepthView depth_mm) const;

 private:
  struct Landmark {
    Eigen::Vector3f point_m, normal;
    float sigma_m = 0;
  };
  struct Pose {
    Eigen::Matrix3f rotation;
    Eigen::Vector3f shift;
  };
  struct Tally;

  template <class Visit>
  void for_each_reading(DepthView depth_mm, const RigidTransform& now_from_then, Visit visit) const;
  [[nodiscard]] RigidTransform improved(DepthView depth_mm, const RigidTransform& now_from_then,
                                        float widening) const;
  [[nodiscard]] Tally tally(DepthView depth_mm, const RigidTransform& now_from_then) const;

  Lens lens_;
  Image<Eigen::Vector2f> rays_;
  std::vector<Landmark> landmarks_;
};

}  // namespace roomcast::alignment
