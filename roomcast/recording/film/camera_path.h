// SPDX-License-Identifier: Apache-2.0
// CameraPath: a camera's path through a room: a smooth curve through keys of time, eye and target.
// World frame, metres, seconds since the film began. Immutable. Method: cubic Hermite curves
// through the keys, with tangents from their neighbours (Catmull & Rom 1974, "A Class of Local
// Interpolating Splines"), for unevenly spaced keys.
#pragma once

#include <filesystem>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::recording {

struct CameraKey {
  double time_s = 0;
  Eigen::Vector3d eye_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d target_m = Eigen::Vector3d::Zero();
};

class CameraPath {
 public:
  static constexpr std::size_t kMaxKeys = 100'000;
  /// Minimum distance from eye to target.
  static constexpr double kNearestTarget_m = 0.01;

  /// kInvalidArgument, naming the key: no keys, too many, times that do not increase, numbers that
  /// are not finite, a target at the eye.
  static Result<CameraPath> create(std::vector<CameraKey> keys);

  /// View frame: x right, y up, -z forward. Constant before the first key and after the last.
  [[nodiscard]] RigidTransform world_from_view(double time_s) const;

 private:
  explicit CameraPath(std::vector<CameraKey> keys) : keys_(std::move(keys)) {}
  std::vector<CameraKey> keys_;
};

/// File: {"keys": [{"time_s": 0, "at": [x, y, z], "look": [x, y, z]}, ...]}. Errors as
/// read_json_object and CameraPath::create.
[[nodiscard]] Result<CameraPath> read_camera_path(const std::filesystem::path& file);

/// A slow swing from `eye_m` to both sides about the vertical axis through `pivot_m`.
[[nodiscard]] CameraPath swinging_path(const Eigen::Vector3d& eye_m, const Eigen::Vector3d& pivot_m,
                                       double length_s);

}  // namespace roomcast::recording
