// SPDX-License-Identifier: Apache-2.0
// For tests: views of the simulated room from its corners, computed once.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "roomcast/alignment/feature/room_fixture.h"
#include "roomcast/alignment/feature/sensor_view.h"

namespace roomcast::alignment {

struct ViewFixture {
  RigidTransform world_from_depth;
  std::shared_ptr<const SensorView> view;
};

inline ViewFixture view_fixture(const RoomFixture& room, const std::string& name,
                                const RigidTransform& world_from_depth) {
  auto view = make_sensor_view(bundle_fixture(room, name, world_from_depth));
  ROOMCAST_ASSERT(view.ok());
  return {world_from_depth, std::make_shared<const SensorView>(std::move(*view))};
}

/// Two corners of the same long wall, about 90 degrees apart, and the corner diagonally opposite
/// the first.
inline const ViewFixture& first_corner() {
  static const ViewFixture view = view_fixture({}, "s0", corner_pose(2, 1.5));
  return view;
}
inline const ViewFixture& second_corner() {
  static const ViewFixture view = view_fixture({}, "s1", corner_pose(-2, 1.5));
  return view;
}
inline const ViewFixture& third_corner() {
  static const ViewFixture view = view_fixture({}, "s2", corner_pose(-2, -1.5));
  return view;
}

/// A room that looks the same rotated by 180 degrees, except for one box; seen from opposite
/// corners.
inline RoomFixture nearly_symmetric_room() {
  RoomFixture room;
  room.turned = true;
  room.boxes = {{Eigen::Vector3d(-2.5, 0, -2), Eigen::Vector3d(-1.8, 1.5, -1.2)},
                {Eigen::Vector3d(1.8, 0, 1.2), Eigen::Vector3d(2.5, 1.5, 2)},
                {Eigen::Vector3d(0.2, 0, 0), Eigen::Vector3d(1, 0.7, 0.7)}};
  return room;
}
inline const ViewFixture& one_side() {
  static const ViewFixture view =
      view_fixture(nearly_symmetric_room(), "one", corner_pose(2, -1.5));
  return view;
}
inline const ViewFixture& other_side() {
  static const ViewFixture view =
      view_fixture(nearly_symmetric_room(), "other", corner_pose(-2, 1.5));
  return view;
}

inline RigidTransform true_pose(const ViewFixture& a, const ViewFixture& b) {
  return a.world_from_depth.inverse() * b.world_from_depth;
}

}  // namespace roomcast::alignment
