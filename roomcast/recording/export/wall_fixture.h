// SPDX-License-Identifier: Apache-2.0
// For tests: two sensors facing a wall at world z = -2 m; the second is twice as far away and half
// a metre to the right. One sees red, the other green.
#pragma once

#include <memory>
#include <vector>

#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

inline std::vector<SetSensor> wall_sensors() {
  const CameraIntrinsics camera = {
      .width = 64, .height = 48, .fx = 60, .fy = 60, .cx = 31.5, .cy = 23.5};
  return {{"near", camera, 10, 0}, {"far", camera, 10, 0}};
}

inline RigidTransform wall_pose(std::size_t sensor) {
  RigidTransform pose;
  pose.rotation = Eigen::Vector3d(1, -1, -1).asDiagonal();
  pose.translation_m = sensor == 0 ? Eigen::Vector3d(0, 1, 0) : Eigen::Vector3d(0.5, 1, 2);
  return pose;
}

inline FrameSet wall_set() {
  FrameSet set;
  for (std::size_t i = 0; i < 2; ++i) {
    auto pictures = std::make_shared<codec::DecodedFrame>();
    pictures->depth_mm = DepthImage(64, 48, i == 0 ? 2000 : 4000);
    pictures->color = ColorImage(64, 48, i == 0 ? Rgb8{200, 0, 0} : Rgb8{0, 200, 0});
    pictures->color_seen = MaskImage(64, 48, 255);
    set.frames.push_back({i, std::move(pictures), wall_pose(i), {}});
  }
  return set;
}

}  // namespace roomcast::recording
