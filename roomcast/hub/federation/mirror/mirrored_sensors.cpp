// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/mirror/mirrored_sensors.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "roomcast/wire/frame_header.h"

namespace roomcast::hub::federation {
namespace {

namespace wpb = wire::pb;

const net::CloseReason kGone{net::close_code::kGoingAway, "it has left the other hub"};

/// The join data of a sensor.
wpb::SensorRole role_of(const wpb::SensorEntry& entry) {
  wpb::SensorRole role;
  *role.mutable_calibration() = entry.calibration();
  role.set_fps(entry.fps());
  if (entry.placement() == wpb::PLACEMENT_GIVEN) {
    *role.mutable_world_from_depth() = entry.world_from_depth();
  }
  return role;
}

bool is_same_sensor(const SensorThere& a, const SensorThere& b) {
  return a.entry.name() == b.entry.name() && a.token_id == b.token_id &&
         role_of(a.entry).SerializeAsString() == role_of(b.entry).SerializeAsString();
}

std::uint32_t added_error_us(std::uint32_t error_us, nanoseconds more) {
  if (error_us == wire::kClockErrorUnknown) return error_us;
  const auto more_us = std::chrono::ceil<std::chrono::microseconds>(more).count();
  const std::uint64_t sum = error_us + static_cast<std::uint64_t>(more_us);
  return sum < wire::kClockErrorUnknown ? static_cast<std::uint32_t>(sum)
                                        : wire::kClockErrorUnknown;
}

}  // namespace

wpb::SensorPlacement placement_of(const wpb::SensorEntry& entry, SensorId here) {
  wpb::SensorPlacement placement;
  placement.set_sensor_id(here.value);
  placement.set_bundle_number(std::numeric_limits<std::uint32_t>::max());
  placement.set_note(entry.placement_note());
  if (entry.placement() != wpb::PLACEMENT_ALIGNED) return placement;
  *placement.mutable_world_from_depth() = entry.world_from_depth();
  placement.set_expected_error_mm(entry.expected_error_mm());
  placement.set_unverified(entry.unverified());
  placement.set_depth_scale(entry.depth_scale() == 0 ? 1 : entry.depth_scale());
  return placement;
}

MirroredSensors::MirroredSensors(std::uint64_t other_hub, std::string room, std::string token,
                                 hub::BackplaneEvents& here, NewConnection new_connection)
    : other_hub_(other_hub),
      room_(std::move(room)),
      token_(std::move(token)),
      here_(here),
      new_connection_(std::move(new_connection)) {}

// ---- from the other hub

void MirroredSensors::set_online(const std::vector<SensorThere>& online) {
  deliver_frames();  // they were sent before this list
  std::set<std::uint32_t> ids;
  for (const SensorThere& sensor : online) {
    ids.insert(sensor.entry.id());
    update(sensor);
  }
  for (auto sensor = sensors_.begin(); sensor != sensors_.end();) {
    sensor = ids.contains(sensor->first) ? std::next(sensor) : leave(sensor);
  }
}

void MirroredSensors::update(const SensorThere& sensor) {
  const auto known = sensors_.find(sensor.entry.id());
  if (known == sensors_.end()) return join(sensor);
  if (!is_same_sensor(known->second.there, sensor)) {
    leave(known);
    return join(sensor);
  }
  const bool has_just_moved = sensor.entry.moved() && !known->second.there.entry.moved();
  known->second.there = sensor;
  if (!has_just_moved || !known->second.id) return;
  wpb::Control moved;
  moved.mutable_sensor_moved();
  here_.on_control(known->second.connection, moved);
}

void MirroredSensors::join(const SensorThere& sensor) {
  const hub::ConnectionPtr connection = new_connection_();
  sensors_[sensor.entry.id()] = {.there = sensor, .connection = connection->id()};
  wpb::Join join;
  join.set_room(room_);
  join.set_token(token_);
  join.set_name(sensor.entry.name());
  *join.mutable_sensor() = role_of(sensor.entry);
  here_.on_join({.connection = connection,
                 .address = "another hub",
                 .peer = "",
                 .token_id_there = sensor.token_id,
                 .other_hub = other_hub_,
                 .is_backplane = true},
                join);
}

MirroredSensors::Sensors::iterator MirroredSensors::leave(Sensors::iterator sensor) {
  const ConnectionId connection = sensor->second.connection;
  const auto next = sensors_.erase(sensor);
  here_.on_left(connection, kGone);
  return next;
}

void MirroredSensors::frame(net::MessageBuffer message) {
  auto header = wire::parse_frame(message.payload());
  if (!header || !clock_) return;
  const auto sensor = sensors_.find(header->sensor.value);
  if (sensor == sensors_.end() || !sensor->second.id) return;
  header->sensor = *sensor->second.id;
  header->capture_time = *time_here(header->capture_time);
  header->clock_error_us = added_error_us(header->clock_error_us, clock_->error);
  wire::stamp_source(message.payload(), *header);
  received_.push_back({sensor->second.connection, *header, std::move(message)});
}

void MirroredSensors::deliver_frames() {
  if (received_.empty()) return;
  auto together = std::exchange(received_, {});
  here_.on_frames(together);
  together.clear();
  received_ = std::move(together);  // keeps the memory
}

void MirroredSensors::forward(std::uint32_t id_there, const wpb::Control& message) {
  const auto sensor = sensors_.find(id_there);
  if (sensor != sensors_.end() && sensor->second.id) {
    here_.on_control(sensor->second.connection, message);
  }
}

std::optional<RoomTime> MirroredSensors::time_here(RoomTime there) const {
  if (!clock_) return std::nullopt;
  const HostTime about{there.time_since_epoch() - clock_->room_minus_host};
  return RoomTime(about.time_since_epoch() - clock_->drifted(about - clock_->at));
}

void MirroredSensors::on_hub_lost() {
  clock_.reset();
  received_.clear();
  while (!sensors_.empty()) leave(sensors_.begin());
}

// ---- from the room here

MirroredSensors::Sensors::iterator MirroredSensors::find(ConnectionId connection) {
  return std::ranges::find_if(
      sensors_, [connection](const auto& entry) { return entry.second.connection == connection; });
}

bool MirroredSensors::has(std::string_view name) const {
  return std::ranges::any_of(sensors_, [name](const auto& entry) {
    return entry.second.id && entry.second.there.entry.name() == name;
  });
}

std::optional<wpb::Control> MirroredSensors::on_room_message(ConnectionId to,
                                                             const wpb::Control& message) {
  const auto sensor = find(to);
  if (sensor == sensors_.end()) return std::nullopt;
  if (message.has_welcome()) {
    sensor->second.id = SensorId{static_cast<std::uint16_t>(message.welcome().sensor_id())};
  }
  if (!message.has_key_request()) return std::nullopt;
  wpb::Control request;
  request.mutable_key_request()->set_sensor_id(sensor->first);
  return request;
}

bool MirroredSensors::on_removed(ConnectionId connection) {
  const auto sensor = find(connection);
  if (sensor == sensors_.end()) return false;
  std::erase_if(received_, [connection](const auto& frame) { return frame.from == connection; });
  sensors_.erase(sensor);
  return true;
}

}  // namespace roomcast::hub::federation
