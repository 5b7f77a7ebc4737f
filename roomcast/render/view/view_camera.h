// SPDX-License-Identifier: Apache-2.0
// The eye a picture is drawn for: where it is, where it looks, how wide. View frame: x right, y up,
// -z forward (OpenGL, OpenXR, WebXR); world: y up, metres. Lens: an ideal pinhole, square pixels,
// centred.
#pragma once

#include <Eigen/Core>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::render {

struct ViewCamera {
  RigidTransform world_from_view;
  double vertical_fov_rad = 1.0;
  int width = 1280, height = 720;  // pixels
  double near_m = 0.05, far_m = 50;

  /// kInvalidArgument naming what is wrong: size 1..kMaxImageSide, 0 < fov < pi, 0 < near < far,
  /// all finite.
  [[nodiscard]] Status check() const;
};

/// Focal length of both axes, in pixels.
[[nodiscard]] double focal_length_px(const ViewCamera& camera);

/// OpenGL's perspective matrix: view frame -> clip, depth -1 at near_m and +1 at far_m.
[[nodiscard]] Eigen::Matrix4f clip_from_view(const ViewCamera& camera);

/// Turns an optical frame (x right, y down, z forward) into the view frame at the same place.
[[nodiscard]] RigidTransform optical_from_view();

/// The pose of an eye at `eye_m` that looks at `target_m`, its head up (straight up or down: top
/// towards -z).
[[nodiscard]] RigidTransform world_from_view_looking_at(const Eigen::Vector3d& eye_m,
                                                        const Eigen::Vector3d& target_m);

}  // namespace roomcast::render
