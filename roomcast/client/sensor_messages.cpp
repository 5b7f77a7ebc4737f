// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/sensor_messages.h"

#include "roomcast/client/room/calibration_message.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::client {

wire::pb::Join join_message(const PublisherOptions& options) {
  wire::pb::Join join;
  join.set_room(options.room);
  show(options.credential, join);
  join.set_name(options.name);
  auto& sensor = *join.mutable_sensor();
  sensor.set_fps(options.fps);
  *sensor.mutable_calibration() = message_from_calibration(options.calibration);
  if (options.world_from_depth)
    wire::write_transform(*options.world_from_depth, *sensor.mutable_world_from_depth());
  sensor.set_follows_rate(options.follows_rate);
  sensor.set_takes_views(options.takes_views);
  if (options.settings) *sensor.mutable_settings() = *options.settings;
  return join;
}

wire::pb::Control moved_message() {
  wire::pb::Control message;
  message.mutable_sensor_moved();
  return message;
}

}  // namespace roomcast::client
