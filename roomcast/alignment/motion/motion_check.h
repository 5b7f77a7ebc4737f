// SPDX-License-Identifier: Apache-2.0
// MotionCheck: tests whether the sensor itself has moved since its calibration bundle. Compares one
// depth picture with the bundle's by projective point-to-plane ICP (Blais & Levine 1995; Chen &
// Medioni 1992) with depth-noise weights, starting from no motion, under a robust kernel that
// narrows from step to step (graduated non-convexity, Blake & Zisserman 1987). Moving people and
// objects are a minority that the kernel rejects as outliers; occluded points are not counted.
// Directions that the view does not constrain (along a bare wall) count as no motion. About a
// millisecond of CPU per picture. Metres, radians. Thread-safe (immutable).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/bundle/calibration_bundle.h"
#include "roomcast/alignment/view/depth_surface.h"

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

/// Chosen on recordings and simulated rooms of docs/benchmarks/live-alignment.md, unless noted.
struct MotionCheckOptions {
  DepthSurfaceOptions surface;
  std::size_t max_landmarks = 3000;  // surface points of the bundle; for time
  float fit_sigmas = 3;              // largest misfit of a point that fits
  float hidden_m = 0.05F;            // nearer by more than a fit: occluded
  float gone_m = 0.10F;              // farther by more than a fit: the surface is gone
  double max_independent = 1500;     // readings: errors of neighbours are correlated
  double lever_m = 2.5;              // at which rotation and shift have equal weight; by hand
  double observable_m = 0.007;       // a direction known less exactly counts as no motion
  std::array<float, 7> widening = {8, 6, 4, 2, 1, 1, 1};  // the kernel's width in each step, sigmas

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("surface", surface);
    visit("max_landmarks", max_landmarks, Range{10, 1e6});
    visit("fit_sigmas", fit_sigmas, Range{0.1, 100});
    visit("hidden_m", hidden_m, Range{0, 10});
    visit("gone_m", gone_m, Range{0, 10});
    visit("max_independent", max_independent, Range{1, 1e7});
    visit("lever_m", lever_m, Range{0.01, 100});
    visit("observable_m", observable_m, Range{1e-5, 10});
    visit("widening", widening, Range{0.1, 1000});
  }
  [[nodiscard]] Status check() const { return check_fields("MotionCheckOptions", *this); }
};

class MotionCheck {
 public:
  /// `bundle` has passed check().
  explicit MotionCheck(const CalibrationBundle& bundle, const MotionCheckOptions& options = {});

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

  MotionCheckOptions options_;
  Lens lens_;
  Image<Eigen::Vector2f> rays_;
  std::vector<Landmark> landmarks_;
};

}  // namespace roomcast::alignment
