// SPDX-License-Identifier: Apache-2.0
// HeadDetector: finds the heads of moving people in the view of one sensor. Readings nearer than
// the depth of the calibration bundle are foreground. In a plan view of the foreground on the floor
// (Darrell et al. 1998; Harville 2004), a blob of the size and height of a person is a person, and
// its topmost part is the head. A few milliseconds per picture. Metres, in the depth camera's
// frame. Single-threaded.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/bundle/calibration_bundle.h"
#include "roomcast/alignment/view/planes.h"

namespace roomcast::alignment {

/// Above the floor.
inline constexpr float kMinHead_m = 1.0F, kMaxHead_m = 2.2F;
inline constexpr std::size_t kMaxHeads = 4;

/// The floor plane in the sensor's view; nothing if it sees no floor.
[[nodiscard]] std::optional<Plane> floor_of(const CalibrationBundle& bundle);

/// Transform to the level frame: y up, the floor at y = 0, the sensor above its origin, looking
/// along -z.
[[nodiscard]] RigidTransform level_from_depth(const Plane& floor);

class HeadDetector {
 public:
  /// `bundle` has passed check(), `floor` is its floor.
  HeadDetector(const CalibrationBundle& bundle, const Plane& floor);
  ~HeadDetector();
  HeadDetector(HeadDetector&&) noexcept;
  HeadDetector& operator=(HeadDetector&&) noexcept;

  /// `depth_mm` has the bundle's size. Returns the centre of the visible surface of each head's
  /// crown, which is on the sensor's side of the head. Largest person first.
  [[nodiscard]] std::vector<Eigen::Vector3f> find(DepthView depth_mm);

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

}  // namespace roomcast::alignment
