// SPDX-License-Identifier: Apache-2.0
// ViewCamera: the eye for which a picture is drawn: pose, field of view, size. View frame: x right,
// y up, -z forward (OpenGL, OpenXR, WebXR). World frame: y up, metres. Lens: an ideal centred
// pinhole with square pixels.
#pragma once

#include <Eigen/Core>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/geometry/view_cone.h"

namespace roomcast::render {

struct ViewCamera {
  RigidTransform world_from_view;
  double vertical_fov_rad = 1.0;
  int width = 1280, height = 720;  // pixels
  double near_m = 0.05, far_m = 50;

  /// kInvalidArgument with the reason, unless size is 1..kMaxImageSide, 0 < fov < pi, 0 < near <
  /// far, and all values are finite.
  [[nodiscard]] Status check() const;
};

/// True if a picture can be so many pixels wide or high: 1..kMaxImageSide.
[[nodiscard]] bool is_legal_side(int pixels);

/// Focal length of both axes, in pixels.
[[nodiscard]] double focal_length_px(const ViewCamera& camera);

/// From the middle of the picture to its corners, sides, and top and bottom.
[[nodiscard]] ViewAngles view_angles(const ViewCamera& camera);

/// OpenGL's perspective matrix: view frame -> clip, depth -1 at near_m and +1 at far_m.
[[nodiscard]] Eigen::Matrix4f clip_from_view(const ViewCamera& camera);

/// Maps the view frame to the optical frame (x right, y down, z forward) at the same position.
[[nodiscard]] RigidTransform optical_from_view();

/// The pose of an upright eye at `eye_m` that looks at `target_m` (straight up or down: the
/// picture's top towards -z).
[[nodiscard]] RigidTransform world_from_view_looking_at(const Eigen::Vector3d& eye_m,
                                                        const Eigen::Vector3d& target_m);

}  // namespace roomcast::render
