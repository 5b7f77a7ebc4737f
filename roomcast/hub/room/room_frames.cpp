// SPDX-License-Identifier: Apache-2.0
// How a Room handles frames: which it takes, the sets that it makes of them, key frames, and which
// viewers get which sensors' frames.
#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "roomcast/hub/room/room.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

namespace pb = wire::pb;

std::optional<Refusal> Room::fault_of(ConnectionId from, const wire::FrameHeader& header,
                                      RoomTime now) {
  const RoomSensor* sensor = sensors_.find(from);
  if (sensor == nullptr) {
    return Refusal{pb::ERROR_UNEXPECTED, "only a sensor that has joined may send frames"};
  }
  if (header.sensor != sensor->id) {
    return Refusal{pb::ERROR_UNEXPECTED, "this frame carries the id of another sensor than " +
                                             std::to_string(sensor->id.value)};
  }
  if (header.capture_time > now + wire::kMaxCaptureAhead) {
    return Refusal{pb::ERROR_MALFORMED,
                   "this frame was captured in the future: synchronise the clock first"};
  }
  return std::nullopt;
}

RoomActions Room::frame(ConnectionId from, const wire::FrameHeader& header,
                        net::MessageBuffer message, RoomTime now) {
  IncomingFrame alone{from, header, std::move(message)};
  return frames({&alone, 1}, now);
}

RoomActions Room::frames(std::span<IncomingFrame> together, RoomTime now) {
  RoomActions out;
  for (IncomingFrame& frame : together) take_frame(frame, now, out);
  send_closed_sets(now, out);
  return out;
}

void Room::take_frame(IncomingFrame& frame, RoomTime now, RoomActions& out) {
  if (const auto fault = fault_of(frame.from, frame.header, now)) {
    std::ranges::move(refuse(frame.from, fault->code, fault->sentence, now),
                      std::back_inserter(out));
    return;
  }
  RoomSensor& sensor = *sensors_.find(frame.from);
  if (frame.header.small) {
    if (frame.header.key) sensor.small_key_pace.key_frame_came();
  } else if (frame.header.key) {
    sensor.key_pace.key_frame_came();
    sensor.gone.key_frame_came(now);
  } else if (!modelers_.empty() && sensor.gone.wants_key(now)) {
    std::ranges::move(key_needed(sensor.id, now), std::back_inserter(out));
  }
  count_frame(frame.header, frame.message.size(), now, sensor.stats);
  sets_.add_frame(frame.header, std::move(frame.message), now);
}

RoomActions Room::key_needed(SensorId id, RoomTime now) {
  RoomActions out;
  RoomSensor* const sensor = sensors_.find(id);  // null: an old roster, or an invalid ID
  if (sensor == nullptr || !sensor->connection) return out;
  if (sensor->key_pace.request(now)) ask_for_key(*sensor, out);
  return out;
}

RoomActions Room::small_needed(ConnectionId viewer, const SmallNeeds& needs, RoomTime now) {
  RoomActions out;
  const auto found = viewers_.find(viewer);
  if (found == viewers_.end()) return out;
  Viewer& slow = found->second;
  slow.small = needs.wanted;
  if (std::exchange(slow.held_back, needs.held_back) != needs.held_back)
    out.push_back(SendControl{{viewer}, left_out(slow)});
  tell_demands(now, out);
  for (const SensorId id : needs.keys) {
    RoomSensor* const sensor = sensors_.find(id);
    if (sensor == nullptr || !sensor->connection) continue;
    if (sensor->small_key_pace.request(now)) ask_for_key(*sensor, out, true);
  }
  return out;
}

/// Some viewer's line takes no more.
bool Room::is_wanted_small(SensorId sensor) const {
  return std::ranges::any_of(viewers_, [sensor](const auto& entry) {
    return std::ranges::find(entry.second.small, sensor) != entry.second.small.end();
  });
}

void Room::ask_for_key(const RoomSensor& sensor, RoomActions& out, bool small) {
  pb::Control request;
  request.mutable_key_request()->set_sensor_id(sensor.id.value);
  request.mutable_key_request()->set_small(small);
  out.push_back(SendControl{{*sensor.connection}, std::move(request)});
}

/// Those that are online, and send each of their frames.
std::size_t Room::sensors_in_each_set() const {
  return static_cast<std::size_t>(std::ranges::count_if(sensors_.all(), [](const auto& sensor) {
    return sensor.connection && !sensor.told.unseen() && !sensor.told.base_only();
  }));
}

void Room::send_closed_sets(RoomTime now, RoomActions& out) {
  for (FrameSetPtr& set : sets_.take_closed(now)) {
    count_set(*set, sensors_in_each_set(), set_stats_);
    if (!viewers_.empty() || !modelers_.empty()) out.emplace_back(SendSet{std::move(set)});
  }
}

/// Tells the culling where this sensor sees surfaces, unless it knows. Nothing is known of a sensor
/// at another hub, nor of one whose pose is not valid.
void Room::follow_surface(RoomSensor& sensor) {
  const RigidTransform& pose = sensor.pose.world_from_depth;
  const bool is_known = sensor.coarse_depth && sensor.pose.is_placed() && !sensor.pose.is_moved();
  if (!is_known) {
    sensor.surface_pose.reset();
    return culling_.forget_sensor(sensor.id);
  }
  if (sensor.surface_pose == pose) return;
  sensor.surface_pose = pose;
  culling_.set_surface(
      sensor.id, seen_surface(*sensor.coarse_depth, sensor.description.calibration().depth(), pose,
                              culling_.surface_of(sensor.id)));
}

/// The message that tells a viewer which sensors' frames the hub leaves out for it.
pb::Control Room::left_out(const Viewer& viewer) {
  pb::Control message;
  pb::UnseenSensors& unseen = *message.mutable_unseen_sensors();
  for (std::uint32_t sensor = 0; sensor < viewer.details.size(); ++sensor) {
    if (viewer.details[sensor] == Detail::kBaseOnly) unseen.add_base_only(sensor);
    if (viewer.details[sensor] == Detail::kPaused) unseen.add_paused(sensor);
  }
  for (const SensorId sensor : viewer.held_back) {
    const Detail detail = detail_of(viewer.details, sensor);
    if (detail == Detail::kPaused) continue;
    unseen.add_held_back(sensor.value);
    if (detail != Detail::kBaseOnly) unseen.add_base_only(sensor.value);
  }
  return message;
}

/// Tells viewers and their queues of the frames that are left out from now on.
void Room::cull(RoomTime now, RoomActions& out) {
  std::vector<ViewCulling::Change> changes = culling_.update(now);
  for (ViewCulling::Change& change : changes) {
    const auto found = viewers_.find(change.viewer);
    if (found == viewers_.end()) continue;
    Viewer& viewer = found->second;
    viewer.details = change.details;
    out.push_back(SetDetails{change.viewer, std::move(change.details)});
    out.push_back(SendControl{{change.viewer}, left_out(viewer)});
    for (const SensorId sensor : change.resumed) {
      std::ranges::move(key_needed(sensor, now), std::back_inserter(out));
    }
  }
  if (!changes.empty()) tell_demands(now, out);
}

}  // namespace roomcast::hub
