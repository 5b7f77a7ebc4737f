// SPDX-License-Identifier: Apache-2.0
// HeadDetector: where the heads of people are that move in one sensor's view. What is nearer than
// the calibration bundle's depth is somebody or something; seen from above (a plan view on the
// floor, Darrell et al. 1998; Harville 2004), what is as large and as tall as a person is one, and
// their head is what is topmost. A few milliseconds per picture. Metres, in the depth camera's
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

/// The floor that a sensor sees; nothing where it sees none.
[[nodiscard]] std::optional<Plane> floor_of(const CalibrationBundle& bundle);

/// A frame with y up, the floor at y = 0, the sensor above its origin, looking along -z.
[[nodiscard]] RigidTransform level_from_depth(const Plane& floor);

class HeadDetector {
 public:
  /// `bundle` has passed check(), `floor` is its floor.
  HeadDetector(const CalibrationBundle& bundle, const Plane& floor);
  ~HeadDetector();
  HeadDetector(HeadDetector&&) noexcept;
  HeadDetector& operator=(HeadDetector&&) noexcept;

  /// `depth_mm` has the bundle's size. The middle of what is seen of each head's crown: its
  /// surface, so on the sensor's side of it. Largest person first.
  [[nodiscard]] std::vector<Eigen::Vector3f> find(DepthView depth_mm);

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

}  // namespace roomcast::alignment
