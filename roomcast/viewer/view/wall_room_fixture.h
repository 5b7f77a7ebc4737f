// SPDX-License-Identifier: Apache-2.0
// Fixture for tests: a room with one sensor that sees a wall 2 m away.
#pragma once

#include <memory>
#include <utility>

#include "roomcast/client/room/room_snapshot.h"

namespace roomcast::viewer {

/// `color`: a square picture; the depth grid has the same size. The focal length is 60 pixels.
inline client::RoomSnapshot room_with_wall(const RigidTransform& world_from_depth,
                                           ColorImage color) {
  const int side = color.width();
  const double middle = (side - 1) / 2.0;
  auto picture = std::make_shared<client::SensorPicture>();
  picture->frame.depth_mm = DepthImage(side, side, 2000);
  picture->frame.color = std::move(color);
  picture->frame.color_seen = MaskImage(side, side, 255);
  client::RoomSnapshot room;
  client::RoomSensor& sensor = room.sensors.emplace_back();
  sensor.online = true;
  sensor.calibration.depth = {
      .width = side, .height = side, .fx = 60, .fy = 60, .cx = middle, .cy = middle};
  sensor.pose.world_from_depth = world_from_depth;
  sensor.picture = picture;
  return room;
}

}  // namespace roomcast::viewer
