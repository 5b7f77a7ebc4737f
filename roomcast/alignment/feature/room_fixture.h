// SPDX-License-Identifier: Apache-2.0
// For tests: a simulated room with boxes, textured everywhere, and the exact pictures of a sensor
// in it. World: y up, floor at y = 0, metres. A few milliseconds per picture.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "roomcast/alignment/bundle/calibration_bundle.h"

namespace roomcast::alignment {

struct RoomFixture {
  Eigen::AlignedBox3d walls{Eigen::Vector3d(-2.5, 0, -2), Eigen::Vector3d(2.5, 2.6, 2)};
  std::vector<Eigen::AlignedBox3d> boxes = {
      {Eigen::Vector3d(-0.6, 0, -0.3), Eigen::Vector3d(0.5, 0.7, 0.5)},
      {Eigen::Vector3d(-2.5, 0, -2), Eigen::Vector3d(-1.8, 1.5, -1.2)},
      {Eigen::Vector3d(1.5, 0, 1.2), Eigen::Vector3d(2.4, 0.9, 1.9)}};
  std::uint32_t looks = 1;             // seed of the pattern
  double period_m = 0;                 // above 0: the pattern repeats along x and z
  bool turned = false;                 // both halves have the same pattern, rotated by 180 degrees
  Eigen::AlignedBox3d repainted = {};  // region with another pattern
  double coarser = 1;                  // factor by which the pattern is coarser
};

/// A small Kinect-like sensor: depth 200 x 160, colour 400 x 300.
inline SensorCalibration calibration_fixture() {
  SensorCalibration calibration;
  calibration.depth = {200, 160, 145, 145, 99.5, 79.5, 0.05, -0.1};
  calibration.color = {400, 300, 300, 300, 199.5, 149.5, 0.01, -0.02};
  calibration.color_from_depth.translation_m = {-0.05, 0, 0};
  return calibration;
}

inline double pattern_noise(std::uint32_t seed, int x, int y, int z) {
  std::uint32_t h = seed * 0x9E3779B1U ^ static_cast<std::uint32_t>(x) * 0x85EBCA77U ^
                    static_cast<std::uint32_t>(y) * 0xC2B2AE3DU ^
                    static_cast<std::uint32_t>(z) * 0x27D4EB2FU;
  h = (h ^ (h >> 15U)) * 0x2C1B3C6DU;
  h = (h ^ (h >> 12U)) * 0x297A2D39U;
  return static_cast<double>(h >> 8U) / (1U << 24U);
}

/// Grey 0..255: the sum of checker patterns of random grey in several sizes.
inline double pattern_grey(const RoomFixture& room, Eigen::Vector3d at) {
  if (room.period_m > 0) {
    for (const int axis : {0, 2}) at(axis) -= room.period_m * std::floor(at(axis) / room.period_m);
  }
  if (room.turned && at.x() < 0) at = {-at.x(), at.y(), -at.z()};
  double grey = 20;
  std::uint32_t seed = 16 * room.looks + (room.repainted.contains(at) ? 8 : 0);
  at /= room.coarser;
  for (const double size : {0.5, 0.23, 0.11, 0.06}) {
    const auto cell = [&](int axis) {
      return static_cast<int>(std::floor(at(axis) / size + 1e-4));
    };
    grey += 52 * pattern_noise(++seed, cell(0), cell(1), cell(2));
  }
  return grey;
}

/// Distance from `eye` to the first surface along `ray`, in lengths of `ray`.
inline double cast_ray(const RoomFixture& room, const Eigen::Vector3d& eye,
                       const Eigen::Vector3d& ray) {
  double nearest = std::numeric_limits<double>::max();
  for (int axis = 0; axis < 3; ++axis) {  // the walls, from inside
    const double to = ray(axis) > 0 ? room.walls.max()(axis) : room.walls.min()(axis);
    if (ray(axis) != 0) nearest = std::min(nearest, (to - eye(axis)) / ray(axis));
  }
  for (const Eigen::AlignedBox3d& box : room.boxes) {
    double enter = 0, leave = nearest;
    for (int axis = 0; axis < 3; ++axis) {
      const double inverse = 1 / ray(axis);
      const double one = (box.min()(axis) - eye(axis)) * inverse;
      const double other = (box.max()(axis) - eye(axis)) * inverse;
      enter = std::max(enter, std::min(one, other));
      leave = std::min(leave, std::max(one, other));
    }
    if (enter > 0 && enter < leave) nearest = enter;
  }
  return nearest;
}

inline DepthImage depth_fixture(const RoomFixture& room, const CameraIntrinsics& camera,
                                const RigidTransform& world_from_depth) {
  const auto rays = ray_table(camera);
  DepthImage depth_mm(camera.width, camera.height);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector3d ray =
          world_from_depth.rotation * rays.at(x, y).cast<double>().homogeneous();
      const double z = cast_ray(room, world_from_depth.translation_m, ray);
      depth_mm.at(x, y) = static_cast<std::uint16_t>(std::lround(1000 * z));
    }
  }
  return depth_mm;
}

inline ColorImage color_fixture(const RoomFixture& room, const CameraIntrinsics& camera,
                                const RigidTransform& world_from_color) {
  const auto rays = ray_table(camera);
  ColorImage color(camera.width, camera.height);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector3d ray =
          world_from_color.rotation * rays.at(x, y).cast<double>().homogeneous();
      const Eigen::Vector3d& eye = world_from_color.translation_m;
      const auto grey =
          static_cast<std::uint8_t>(pattern_grey(room, eye + cast_ray(room, eye, ray) * ray));
      color.at(x, y) = {grey, grey, grey};
    }
  }
  return color;
}

inline CalibrationBundle bundle_fixture(const RoomFixture& room, const std::string& name,
                                        const RigidTransform& world_from_depth) {
  CalibrationBundle bundle;
  bundle.name = name;
  bundle.calibration = calibration_fixture();
  bundle.depth_mm = depth_fixture(room, bundle.calibration.depth, world_from_depth);
  bundle.color = color_fixture(room, bundle.calibration.color,
                               world_from_depth * bundle.calibration.color_from_depth.inverse());
  return bundle;
}

/// The bundle with the colours of a plain grey room lit from one side, which carry no information
/// about the pose.
inline CalibrationBundle without_pattern(CalibrationBundle bundle) {
  for (int y = 0; y < bundle.color.height(); ++y) {
    for (int x = 0; x < bundle.color.width(); ++x) {
      const auto grey = static_cast<std::uint8_t>(60 + 120 * x / bundle.color.width());
      bundle.color.at(x, y) = {grey, grey, grey};
    }
  }
  return bundle;
}

/// A pose in a corner, looking down at the middle of the room.
inline RigidTransform corner_pose(double x, double z) {
  return world_from_optical_looking_at({x, 1.9, z}, {0.2 * x, 0.4, -0.2 * z});
}

/// `pose` shifted, and rotated about the vertical.
inline RigidTransform beside(const RigidTransform& pose, const Eigen::Vector3d& shift_m,
                             double turn_rad) {
  RigidTransform other = pose;
  other.translation_m += shift_m;
  other.rotation =
      Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitY()).toRotationMatrix() * pose.rotation;
  return other;
}

}  // namespace roomcast::alignment
