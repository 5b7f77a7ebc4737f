// SPDX-License-Identifier: Apache-2.0
// For tests: a room of one sensor that sees a wall 2 m away.
#pragma once

#include <memory>
#include <utility>

#include "roomcast/client/room/room_snapshot.h"

namespace roomcast::viewer {

/// `color` is a square picture and gives the depth grid its size; 60 pixels are as wide as far.
inline client::RoomSnapshot room_with_wall(const RigidTransform& world_from_depth, ColorImage color) {
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
  sensor.world_from_depth = world_from_depth;
  sensor.picture = picture;
  return room;
}

}  // namespace roomcast::viewer
