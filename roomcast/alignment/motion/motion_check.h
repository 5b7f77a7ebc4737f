// SPDX-License-Identifier: Apache-2.0
// MotionCheck: tests whether the sensor itself has moved since its calibration bundle. Compares one
// depth picture with the bundle's by projective point-to-plane ICP (Blais & Levine 1995; Chen &
// Medioni 1992) with depth-noise weights, starting from no motion, under a robust kernel that
// narrows from step to step (graduated non-convexity, Blake & Zisserman 1987). Moving people and
// objects are a minority that the kernel rejects as outliers; occluded points are not counted.
// Directions that the view does not constrain (along a bare wall) count as no motion. About a
// millisecond of CPU per picture. Metres, radians. Thread-safe (immutable).
#pragma once

#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/bundle/calibration_bundle.h"
#include "roomcast/alignment/view/lens.h"

namespace roomcast::alignment {

/// The evidence of one picture. Shares are of the bundle's surface points that can be compared,
/// unless noted.
struct MotionEvidence {
  RigidTransform now_from_then;
  double shift_m = 0, angle_rad = 0;
  double comparable = 0;      // share of all points: with a reading that is not an occluder
  double agree_if_still = 0;  // share that fits if the sensor has not moved
  double agree_if_moved = 0;  // share that fits if it has moved by now_from_then
  double gain = 0;            // reduction of the mean misfit by the motion, in squared sigmas
  double gone = 0;  // share of all points with readings: seen through if the sensor has not moved
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
