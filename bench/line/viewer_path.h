// SPDX-License-Identifier: Apache-2.0
// ViewerPath: how a person's head moved while watching a room, to be walked again. World frame: y
// up, right-handed, metres.
#pragma once

#include <filesystem>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::bench {

class ViewerPath {
 public:
  struct Step {
    nanoseconds time{};
    RigidTransform world_from_head;  // x right, y up, -z forward
  };

  /// Reads lines "ms, x, y, z, 3 Euler angles, 4 of a quaternion, forward x, y, z, up x, y, z", as
  /// Unity writes them: left-handed, y up, z forward. Lines that are no pose are skipped. Errors:
  /// those of reading the file; kMalformed: it has fewer than two poses.
  static Result<ViewerPath> read(const std::filesystem::path& file);

  /// A walk on a circle of this radius, whose walker looks at the middle, and at times aside.
  static ViewerPath round_walk(double radius_m, nanoseconds length);

  /// The path, moved so that the middle of what was looked at is above this place on the floor.
  [[nodiscard]] ViewerPath around(const Eigen::Vector2d& floor_m) const;

  /// The pose at this time since the path's beginning. At its end it goes back the same way.
  [[nodiscard]] RigidTransform at(nanoseconds time) const;
  [[nodiscard]] nanoseconds length() const { return steps_.back().time; }

 private:
  explicit ViewerPath(std::vector<Step> steps) : steps_(std::move(steps)) {}
  std::vector<Step> steps_;  // at least two, in order of time, from 0 on
};

/// A ray along the floor.
struct FloorRay {
  Eigen::Vector2d from_m, direction;  // x, z
};

/// The place that the rays pass nearest, by least squares. {0, 0} if they are all parallel.
[[nodiscard]] Eigen::Vector2d nearest_to_all(const std::vector<FloorRay>& rays);

}  // namespace roomcast::bench
