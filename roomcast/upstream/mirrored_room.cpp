// SPDX-License-Identifier: Apache-2.0
#include "roomcast/upstream/mirrored_room.h"

#include <limits>
#include <set>
#include <utility>

#include "roomcast/wire/frame_header.h"

namespace roomcast::upstream {
namespace {

namespace pb = wire::pb;

const net::CloseReason kGone{net::close_code::kGoingAway, "it has left the other hub"};

/// What a sensor says of itself on joining.
pb::SensorRole role_of(const pb::SensorEntry& entry) {
  pb::SensorRole role;
  *role.mutable_calibration() = entry.calibration();
  role.set_fps(entry.fps());
  if (entry.placement() == pb::PLACEMENT_GIVEN) {
    *role.mutable_world_from_depth() = entry.world_from_depth();
  }
  return role;
}

bool is_the_same(const pb::SensorEntry& a, const pb::SensorEntry& b) {
  return a.name() == b.name() && role_of(a).SerializeAsString() == role_of(b).SerializeAsString();
}

/// What alignment knows of it; the newest word there is.
pb::SensorPlacement placement_of(const pb::SensorEntry& entry, SensorId here) {
  pb::SensorPlacement placement;
  placement.set_sensor_id(here.value);
  placement.set_bundle_number(std::numeric_limits<std::uint32_t>::max());
  placement.set_note(entry.placement_note());
  if (entry.placement() != pb::PLACEMENT_ALIGNED) return placement;
  *placement.mutable_world_from_depth() = entry.world_from_depth();
  placement.set_expected_error_mm(entry.expected_error_mm());
  return placement;
}

std::uint32_t added_error_us(std::uint32_t error_us, nanoseconds more) {
  if (error_us == wire::kClockErrorUnknown) return error_us;
  const auto more_us = std::chrono::ceil<std::chrono::microseconds>(more).count();
  const std::uint64_t sum = error_us + static_cast<std::uint64_t>(more_us);
  return sum < wire::kClockErrorUnknown ? static_cast<std::uint32_t>(sum)
                                        : wire::kClockErrorUnknown;
}

}  // namespace

MirroredRoom::MirroredRoom(std::string room, std::string token, hub::SessionEvents& here,
                           NewConnection new_connection)
    : room_(std::move(room)),
      token_(std::move(token)),
      here_(here),
      new_connection_(std::move(new_connection)) {}

// ---- from the other hub

void MirroredRoom::roster(const pb::Roster& roster) {
  if (!aligner_) {
    pb::Join join;
    join.mutable_aligner();
    aligner_ = join_as(std::move(join));
  }
  std::set<std::uint32_t> online;
  for (const auto& entry : roster.sensors()) {
    if (!entry.online()) continue;
    online.insert(entry.id());
    follow(entry);
  }
  for (auto sensor = sensors_.begin(); sensor != sensors_.end();) {
    sensor = online.contains(sensor->first) ? std::next(sensor) : leave(sensor);
  }
  place_sensors();
}

void MirroredRoom::follow(const pb::SensorEntry& entry) {
  const auto known = sensors_.find(entry.id());
  if (known == sensors_.end()) return join(entry);
  if (!is_the_same(known->second.entry, entry)) {
    leave(known);
    return join(entry);
  }
  Sensor& sensor = known->second;
  const bool has_just_moved = entry.moved() && !sensor.entry.moved();
  sensor.entry = entry;
  if (!has_just_moved || !sensor.id) return;
  pb::Control moved;
  moved.mutable_sensor_moved();
  here_.on_control(sensor.connection, moved);
}

void MirroredRoom::join(const pb::SensorEntry& entry) {
  pb::Join join;
  join.set_name(entry.name());
  *join.mutable_sensor() = role_of(entry);
  sensors_[entry.id()] = {.entry = entry, .connection = join_as(std::move(join)), .id = {}};
}

ConnectionId MirroredRoom::join_as(pb::Join join) {
  const ConnectionId connection = new_connection_();
  join.set_room(room_);
  join.set_token(token_);
  here_.on_join({.from = connection, .address = "another hub", .peer = ""}, join);
  return connection;
}

MirroredRoom::Sensors::iterator MirroredRoom::leave(Sensors::iterator sensor) {
  const ConnectionId connection = sensor->second.connection;
  const auto next = sensors_.erase(sensor);
  here_.on_left(connection, kGone);
  return next;
}

void MirroredRoom::frame(net::MessageBuffer message) {
  auto header = wire::parse_frame(message.payload());
  if (!header || !clock_) return;
  const auto sensor = sensors_.find(header->sensor.value);
  if (sensor == sensors_.end() || !sensor->second.id) return;
  header->sensor = *sensor->second.id;
  header->capture_time = time_here(header->capture_time);
  header->clock_error_us = added_error_us(header->clock_error_us, clock_->error);
  wire::stamp_source(message.payload(), *header);
  here_.on_frame(sensor->second.connection, *header, std::move(message));
}

RoomTime MirroredRoom::time_here(RoomTime there) const {
  const HostTime about{there.time_since_epoch() - clock_->room_minus_host};
  return RoomTime(about.time_since_epoch() - clock_->drifted(about - clock_->at));
}

void MirroredRoom::other_hub_is_gone() {
  clock_.reset();
  while (!sensors_.empty()) leave(sensors_.begin());
  if (!aligner_) return;
  const ConnectionId aligner = *std::exchange(aligner_, std::nullopt);
  aligner_is_welcome_ = false;
  here_.on_left(aligner, kGone);
}

// ---- from the room here

MirroredRoom::Sensors::iterator MirroredRoom::find(ConnectionId connection) {
  return std::ranges::find_if(
      sensors_, [connection](const auto& entry) { return entry.second.connection == connection; });
}

std::optional<pb::Control> MirroredRoom::said(ConnectionId to, const pb::Control& message) {
  if (to == aligner_) {
    if (message.has_welcome()) aligner_is_welcome_ = true;
    if (message.has_welcome()) place_sensors();
    return std::nullopt;
  }
  const auto sensor = find(to);
  if (sensor == sensors_.end()) return std::nullopt;
  if (message.has_welcome()) {
    sensor->second.id = SensorId{static_cast<std::uint16_t>(message.welcome().sensor_id())};
    place_sensors();
  }
  if (!message.has_key_request()) return std::nullopt;
  pb::Control request;
  request.mutable_key_request()->set_sensor_id(sensor->first);
  return request;
}

void MirroredRoom::place_sensors() {
  if (!aligner_is_welcome_) return;
  pb::Control control;
  for (const auto& [there, sensor] : sensors_) {
    if (!sensor.id || sensor.entry.placement() == pb::PLACEMENT_GIVEN) continue;
    *control.mutable_placements()->add_sensors() = placement_of(sensor.entry, *sensor.id);
  }
  if (control.has_placements()) here_.on_control(*aligner_, control);
}

void MirroredRoom::let_go(ConnectionId connection) {
  if (connection == aligner_) aligner_.reset(), aligner_is_welcome_ = false;
  if (const auto sensor = find(connection); sensor != sensors_.end()) sensors_.erase(sensor);
}

}  // namespace roomcast::upstream
