// SPDX-License-Identifier: Apache-2.0
// For tests: views of a simulated room through which a person-sized box walks. Metres, seconds.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/alignment/bundle/depth_instants.h"
#include "roomcast/alignment/feature/room_fixture.h"
#include "roomcast/alignment/feature/sensor_view.h"

namespace roomcast::alignment {

inline constexpr int kWalkInstants = 8;

/// The room at an instant of the walk, along one side of the middle.
inline RoomFixture room_with_walker(RoomFixture room, int instant) {
  const double x = -1.2 + 0.3 * instant, z = 1.0;
  room.boxes.push_back(
      {Eigen::Vector3d(x - 0.15, 0, z - 0.15), Eigen::Vector3d(x + 0.15, 1.7, z + 0.15)});
  return room;
}

/// A view with instants 0.1 s apart; all depth is divided by `depth_scale`, as by a sensor that
/// needs this factor.
inline std::shared_ptr<const SensorView> walk_view(const RoomFixture& room, const std::string& name,
                                                   const RigidTransform& world_from_depth,
                                                   double depth_scale = 1) {
  CalibrationBundle bundle = bundle_fixture(room, name, world_from_depth);
  std::vector<DepthImage> pictures;
  std::vector<double> times_s;
  for (int i = 0; i < kWalkInstants; ++i) {
    pictures.push_back(
        depth_fixture(room_with_walker(room, i), bundle.calibration.depth, world_from_depth));
    times_s.push_back(0.1 * i);
  }
  bundle.instants = depth_instants(pictures, times_s);
  auto view = make_sensor_view(bundle);
  ROOMCAST_ASSERT(view.ok());
  if (depth_scale != 1) view = with_depth_scale(*view, 1 / depth_scale);
  ROOMCAST_ASSERT(view.ok());
  return std::make_shared<const SensorView>(std::move(*view));
}

}  // namespace roomcast::alignment
