// SPDX-License-Identifier: Apache-2.0
// A scene for tests: a wall and a board in front of it, ray-cast on the CPU. Drawn pictures are
// compared with it.
#pragma once

#include <cmath>
#include <optional>

#include "roomcast/render/room_fixture.h"

namespace roomcast::render {

struct TruePoint {
  Eigen::Vector3d in_world;
  double depth_m = 0;  // along the optical axis
  bool is_board = false;
};

/// The point seen by a pixel of a pinhole camera.
inline TruePoint true_point(const CameraIntrinsics& lens, const RigidTransform& world_from_optical,
                            int x, int y) {
  constexpr double kWall_m = -3, kBoard_m = -1.8;  // z in the world
  const Eigen::Vector3d ray((x - lens.cx) / lens.fx, (y - lens.cy) / lens.fy, 1);
  const Eigen::Vector3d along = world_from_optical.rotation * ray;
  const Eigen::Vector3d eye = world_from_optical.translation_m;
  const double board = (kBoard_m - eye.z()) / along.z();
  const Eigen::Vector3d on_board = eye + board * along;
  const bool hits = std::abs(on_board.x()) < 0.35 && std::abs(on_board.y() - 1.5) < 0.3;
  if (hits) return {on_board, board, true};
  const double wall = (kWall_m - eye.z()) / along.z();
  return {eye + wall * along, wall, false};
}

inline Rgb8 true_color(const TruePoint& point) {
  const auto level = [&](double wave, double turn) {
    const Eigen::Vector3d& p = point.in_world;
    return static_cast<std::uint8_t>(
        128 + 60 * std::sin(wave * (p.x() * std::cos(turn) + p.y() * std::sin(turn))));
  };
  return {level(3, 0.3), level(4, 1.2), static_cast<std::uint8_t>(point.is_board ? 220 : 40)};
}

inline SensorPictures true_pictures(const CameraIntrinsics& lens,
                                    const RigidTransform& world_from_optical) {
  SensorPictures pictures = wall(lens, 0, kRed);
  for (int y = 0; y < lens.height; ++y) {
    for (int x = 0; x < lens.width; ++x) {
      const TruePoint point = true_point(lens, world_from_optical, x, y);
      pictures.depth_mm.at(x, y) = static_cast<std::uint16_t>(std::lround(1000 * point.depth_m));
      pictures.color.at(x, y) = true_color(point);
    }
  }
  return pictures;
}

}  // namespace roomcast::render
