// SPDX-License-Identifier: Apache-2.0
// Cameras and transforms of ROS messages as roomcast has them. Lens models after image_geometry:
//   plumb_bob            k1 k2 p1 p2 k3: the same model
//   rational_polynomial  k1 k2 p1 p2 k3 k4 k5 k6: converted (geometry/rational_lens.h)
//   none, or no terms    no distortion
// Thread-safe (no state).
#pragma once

#include "roomcast/core/result.h"
#include "roomcast/geometry/rational_lens.h"
#include "roomcast/recording/ros/messages.h"

namespace roomcast::recording {

/// `is_rectified`: the picture was undistorted by ROS; its projection is `p`. kUnsupported: another
/// lens model; kMalformed: not a camera.
[[nodiscard]] Result<ConvertedLens> lens_of(const ros::CameraInfoMessage& info, bool is_rectified);

/// Sets the colour camera. Its pictures are registered if it is the depth camera itself: the same
/// frame, and the same lens.
void set_color_camera(const CameraIntrinsics& color, const RigidTransform& color_from_depth,
                      bool is_same_frame, SensorCalibration& calibration);

/// kMalformed: not a rigid transform.
[[nodiscard]] Result<RigidTransform> transform_of(const ros::TransformMessage& message);

}  // namespace roomcast::recording
