// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/sensing/kinect_calibration.h"

#include <Eigen/Geometry>

#include "roomcast/source/simulator/scene/value_noise.h"

namespace roomcast::sim {
namespace {

/// -1..1, fixed for a sensor and a trait; 0 for sensor 0.
double deviation(int sensor_index, std::uint32_t trait) {
  if (sensor_index == 0) return 0.0;
  const auto hash = hash_of(static_cast<std::uint32_t>(sensor_index), trait);
  return 2.0 * static_cast<double>(unit_from_hash(hash)) - 1.0;
}

CameraIntrinsics depth_camera(int index) {
  CameraIntrinsics camera;
  camera.width = 512;
  camera.height = 424;
  camera.fx = camera.fy = 364.478 * (1.0 + 0.003 * deviation(index, 1));
  camera.cx = 252.95 + 2.5 * deviation(index, 2);
  camera.cy = 205.88 + 2.5 * deviation(index, 3);
  camera.k1 = 0.0984 + 0.004 * deviation(index, 4);
  camera.k2 = -0.2811 + 0.006 * deviation(index, 5);
  camera.k3 = 0.0952 + 0.004 * deviation(index, 6);
  return camera;
}

CameraIntrinsics color_camera(int index) {
  CameraIntrinsics camera;
  camera.width = 960;
  camera.height = 540;
  camera.fx = camera.fy = 532.0 * (1.0 + 0.003 * deviation(index, 11));
  camera.cx = 479.5 + 3.0 * deviation(index, 12);
  camera.cy = 269.5 + 3.0 * deviation(index, 13);
  camera.k1 = 0.018 + 0.004 * deviation(index, 14);
  camera.k2 = -0.033 + 0.004 * deviation(index, 15);
  camera.p1 = 0.0004 + 0.0002 * deviation(index, 16);
  camera.p2 = -0.0003 + 0.0002 * deviation(index, 17);
  return camera;
}

RigidTransform color_from_depth(int index) {
  const double pitch = 0.0026 + 0.002 * deviation(index, 21);
  const double yaw = 0.0051 + 0.002 * deviation(index, 22);
  const double roll = -0.0022 + 0.002 * deviation(index, 23);
  RigidTransform transform;
  transform.rotation = (Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitX()) *
                        Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY()) *
                        Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()))
                           .toRotationMatrix();
  transform.translation_m = {-0.052 + 0.0005 * deviation(index, 24), 0.0002, -0.0005};
  return transform;
}

}  // namespace

SensorCalibration kinect_calibration(int sensor_index) {
  SensorCalibration calibration;
  calibration.depth = depth_camera(sensor_index);
  calibration.color = color_camera(sensor_index);
  calibration.color_from_depth = color_from_depth(sensor_index);
  return calibration;
}

}  // namespace roomcast::sim
