// SPDX-License-Identifier: Apache-2.0
// ROS 2 messages of a room's sensors, serialised: Image, CameraInfo and PointCloud2 of sensor_msgs,
// TFMessage of tf2_msgs, as their .msg files define them (common_interfaces, geometry2). Frames:
// `world`, with the chosen axis up, and one optical frame for each sensor (x right, y down, z
// forward; REP 103, 105). Metres; depth pictures in millimetres (16UC1, REP 118). Times are
// nanoseconds since 1970-01-01 UTC. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/recording/export/point_cloud.h"

namespace roomcast::ros2 {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::string_view kWorldFrame = "world";

/// 16UC1: millimetres, 0 where there is no reading. The one copy of the pixels.
[[nodiscard]] Bytes depth_image(DepthView depth_mm, std::string_view frame, nanoseconds time);
/// rgb8.
[[nodiscard]] Bytes color_image(ColorView color, std::string_view frame, nanoseconds time);
[[nodiscard]] Bytes camera_info(const CameraIntrinsics& camera, std::string_view frame,
                                nanoseconds time);

/// x, y, z and rgb (as PCL packs it: blue, green, red, 0) of each pixel, not a number where there
/// is no reading, in the sensor's frame. `rays`: of ray_table(); `color` is empty or of its size.
[[nodiscard]] Bytes sensor_points(DepthView depth_mm, ColorView color,
                                  const Image<Eigen::Vector2f>& rays, std::string_view frame,
                                  nanoseconds time);
/// The same of a cloud in `world`; `upright_from_world` turns its points.
[[nodiscard]] Bytes world_points(const recording::PointCloud& cloud,
                                 const RigidTransform& upright_from_world, nanoseconds time);

struct FramePose {
  std::string frame;
  RigidTransform world_from_frame;
  friend bool operator==(const FramePose&, const FramePose&) = default;
};
/// tf2_msgs/TFMessage: `world` to each frame.
[[nodiscard]] Bytes transforms(std::span<const FramePose> poses, nanoseconds time);

}  // namespace roomcast::ros2
