// SPDX-License-Identifier: Apache-2.0
// How a Room handles the messages of sensors and aligners about sensor poses.
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/hub/room/pose_rules.h"
#include "roomcast/hub/room/room.h"

namespace roomcast::hub {

namespace pb = wire::pb;

/// A sensor that comes back with the bundle from which it was placed had only lost its connection.
/// It has monitored its own pose all the time, so its pose counts as verified.
void Room::keep_bundle(RoomSensor& sensor, const pb::CalibrationBundle& bundle, RoomTime now,
                       RoomActions& out) {
  sensor.bundle_hash = std::hash<std::string>{}(bundle.SerializeAsString());
  if (sensor.pose.source == PoseSource::kStored && sensor.bundle_hash == sensor.verified_by) {
    confirm(sensor.pose);
    send_roster(now, out);
  }
  pb::Control message;
  *message.mutable_calibration_bundle() = bundle;
  message.mutable_calibration_bundle()->set_sensor_id(sensor.id.value);
  message.mutable_calibration_bundle()->set_number(++sensor.bundles);
  sensor.bundle = std::move(message);
  if (!aligners_.empty()) out.push_back(SendControl{aligners_, *sensor.bundle});
}

/// Asks all online sensors for sightings; sensors that join later are asked when they join.
void Room::ask_for_sightings(const pb::SightingRequest& request, RoomActions& out) {
  wanted_sightings_ = request;
  pb::Control message;
  *message.mutable_sighting_request() = request;
  std::vector<ConnectionId> online;
  for (const RoomSensor& sensor : sensors_.all()) {
    if (sensor.connection) online.push_back(*sensor.connection);
  }
  if (!online.empty()) out.push_back(SendControl{std::move(online), std::move(message)});
}

/// The sensor's message with the sensor's ID, whatever ID the sensor wrote.
pb::Control Room::with_sensor_id(const RoomSensor& sensor, pb::Control message) {
  if (message.has_sightings()) message.mutable_sightings()->set_sensor_id(sensor.id.value);
  if (message.has_depth_instant()) message.mutable_depth_instant()->set_sensor_id(sensor.id.value);
  return message;
}

void Room::pass_to_aligners(pb::Control message, RoomActions& out) const {
  if (!aligners_.empty()) out.push_back(SendControl{aligners_, std::move(message)});
}

void Room::lose_place(RoomSensor& sensor, RoomTime now, RoomActions& out) {
  sensor.bundle.reset();
  sensor.verified_by.reset();
  sensor.pose.state = PoseState::kMoved;
  sensor.valid_from_bundle = sensor.bundles + 1;
  send_roster(now, out);
}

/// Tells a sensor of this hub the factor on its readings that its pose assumes. A sensor that joins
/// counts as told 1; its bundle tells the aligner which factor it applies.
void Room::tell_depth_scale(RoomSensor& sensor, RoomActions& out) {
  const double factor = sensor.pose.depth_scale;
  if (!sensor.connection || sensor.is_at_other_hub || factor == sensor.told_depth_scale) return;
  sensor.told_depth_scale = factor;
  pb::Control message;
  message.mutable_depth_scale()->set_factor(factor);
  out.push_back(SendControl{{*sensor.connection}, std::move(message)});
}

void Room::take_placements(const pb::Placements& placements, RoomTime now, RoomActions& out) {
  std::vector<KnownSensor> placed;
  for (const pb::SensorPlacement& found : placements.sensors()) {
    RoomSensor* sensor = sensors_.find(wire_id(found.sensor_id()));
    if (sensor == nullptr || found.bundle_number() < sensor->valid_from_bundle) continue;
    SensorPose& pose = sensor->pose;
    if (!take_estimate(found, pose)) continue;
    tell_depth_scale(*sensor, out);
    if (pose.source != PoseSource::kStored && found.bundle_number() == sensor->bundles)
      sensor->verified_by = sensor->bundle_hash;
    placed.push_back(
        {sensor->name, sensor->id, pose.is_estimated() ? std::optional(pose) : std::nullopt});
  }
  if (!placed.empty()) out.push_back(SaveSensors{std::move(placed)});
  send_roster(now, out);
}

/// Shows unplaced sensors in a row next to the placed ones.
void Room::place_unplaced_in_row() {
  std::vector<RigidTransform> placed;
  for (const RoomSensor& sensor : sensors_.all()) {
    if (sensor.pose.is_placed()) placed.push_back(sensor.pose.world_from_depth);
  }
  std::size_t nth = 0;
  for (RoomSensor& sensor : sensors_.all()) {
    if (!sensor.pose.is_placed()) sensor.pose.world_from_depth = placeholder_pose(nth++, placed);
  }
}

}  // namespace roomcast::hub
