// SPDX-License-Identifier: Apache-2.0
// Pose handling of a SharedRoom: one hub estimates the poses of all sensors, and all hubs show
// them.
#include <algorithm>
#include <utility>

#include "roomcast/hub/federation/cluster/shared_room.h"
#include "roomcast/wire/control_check.h"

namespace roomcast::hub::federation {
namespace {

namespace wpb = wire::pb;

bool same_pose(const wpb::SensorEntry& a, const wpb::SensorEntry& b) {
  return std::ranges::equal(a.world_from_depth(), b.world_from_depth());
}

/// Whether another hub's entry of a sensor adds to the entry known here.
bool is_update(const wpb::SensorEntry& remote, const wpb::SensorEntry& here) {
  if (here.placement() == wpb::PLACEMENT_GIVEN || remote.moved()) return false;
  const bool other_note = remote.placement_note() != here.placement_note();
  if (remote.placement() != wpb::PLACEMENT_ALIGNED) return other_note;
  if (here.moved() && same_pose(remote, here)) return false;  // the move is unknown there
  return here.placement() != wpb::PLACEMENT_ALIGNED || !same_pose(remote, here) || other_note ||
         remote.expected_error_mm() != here.expected_error_mm() ||
         remote.depth_scale() != here.depth_scale() || remote.unverified() != here.unverified();
}

}  // namespace

void SharedRoom::set_owner(std::optional<HubId> owner) {
  if (owner == owner_) return;
  owner_ = owner;
  publish_news();
  place_sensors();
  if (!is_owner()) return;
  for (const auto& [id, hub] : others_) {
    if (!hub.sensors.all().empty()) request_bundles(id);
  }
}

/// Applies the owner's poses. Without an owner, those of the hub to which the sensor is connected.
void SharedRoom::place_sensors() {
  if (!is_welcome_ || is_owner()) return;
  wpb::Control control;
  const auto consider = [&](const wpb::SensorEntry& remote) {
    const wpb::SensorEntry* here = entry_of(remote.name());
    if (here == nullptr || !is_update(remote, *here)) return;
    const SensorId id{static_cast<std::uint16_t>(here->id())};
    *control.mutable_placements()->add_sensors() = hub::federation::placement_of(remote, id);
  };
  const auto owner = owner_ ? others_.find(*owner_) : others_.end();
  if (owner != others_.end()) std::ranges::for_each(owner->second.news.placed(), consider);
  for (const auto& [id, hub] : others_) {
    if (owner_) break;
    for (const auto& [there, sensor] : hub.sensors.all()) consider(sensor.there.entry);
  }
  if (control.has_placements()) context_.rooms.on_control(*aligner_, control);
}

/// Forwards messages of sensors and people here to the owner.
void SharedRoom::forward_to_owner(const wpb::Control& local) {
  if (!owner_ || is_owner()) return;
  pb::ToHub message = message_to_hub();
  *message.mutable_news() = news_;
  const auto pass = [&](std::uint32_t sensor_id) {
    if (!is_local(sensor_id)) return;
    message.mutable_sensor_said()->set_sensor_id(sensor_id);
    *message.mutable_sensor_said()->mutable_control() = local;
  };
  if (local.has_calibration_bundle()) pass(local.calibration_bundle().sensor_id());
  if (local.has_sightings()) pass(local.sightings().sensor_id());
  if (local.has_depth_instant()) pass(local.depth_instant().sensor_id());
  if (local.has_nudge()) {
    for (const wpb::SensorEntry& entry : roster_.sensors()) {
      if (entry.id() != local.nudge().sensor_id()) continue;
      message.mutable_nudge()->set_sensor(entry.name());
      *message.mutable_nudge()->mutable_world_from_depth() = local.nudge().world_from_depth();
    }
  }
  if (message.what_case() != pb::ToHub::WHAT_NOT_SET) context_.out.send_to(*owner_, message);
}

void SharedRoom::request_bundles(HubId hub) {
  pb::ToHub message = message_to_hub();
  message.mutable_bundles_please();
  context_.out.send_to(hub, message);
}

pb::ToHub SharedRoom::message_to_hub() const {
  pb::ToHub message;
  message.set_from(context_.own.value);
  message.set_room(context_.room);
  return message;
}

void SharedRoom::on_message(const pb::ToHub& message) {
  const HubId from{message.from()};
  if (message.has_news()) on_news(message.news());
  switch (message.what_case()) {
    case pb::ToHub::kKeyRequest: {
      const SensorId sensor{static_cast<std::uint16_t>(message.key_request().sensor_id())};
      if (is_welcome_) context_.rooms.on_key_needs(*aligner_, {sensor});
      return;
    }
    case pb::ToHub::kSensorSaid:
      return on_sensor_message(from, message.sensor_said());
    case pb::ToHub::kSightingsWanted: {
      if (from != owner_ || !is_welcome_) return;
      wpb::Control control;
      *control.mutable_sighting_request() = message.sightings_wanted().request();
      return context_.rooms.on_control(*aligner_, control);
    }
    case pb::ToHub::kNudge:
      return on_nudge(message.nudge());
    case pb::ToHub::kNewsPlease:
      return context_.out.broadcast_news(news_);
    case pb::ToHub::kBundlesPlease:
      if (!is_welcome_) return;  // the bundles follow the welcome
      leave();
      return join();
    default:
      return;  // of a later version
  }
}

/// Sighting times are converted to this hub's clock.
void SharedRoom::on_sensor_message(HubId from, const pb::SensorMessage& message) {
  const auto hub = others_.find(from);
  if (!is_owner() || hub == others_.end() || !wire::check_control(message.control())) return;
  wpb::Control control = message.control();
  if (!control.has_calibration_bundle() && !control.has_sightings() && !control.has_depth_instant())
    return;
  const auto convert = [&](auto& sighting) {
    const RoomTime there(nanoseconds(static_cast<std::int64_t>(sighting.room_ns())));
    const auto here = hub->second.sensors.time_here(there);
    if (here) sighting.set_room_ns(static_cast<std::uint64_t>(here->time_since_epoch().count()));
    return here.has_value();
  };
  bool times_are_known = true;
  if (control.has_sightings()) {
    for (auto& head : *control.mutable_sightings()->mutable_heads()) {
      times_are_known &= convert(head);
    }
    for (auto& tag : *control.mutable_sightings()->mutable_tags()) times_are_known &= convert(tag);
  }
  if (control.has_depth_instant()) times_are_known = convert(*control.mutable_depth_instant());
  if (times_are_known) hub->second.sensors.forward(message.sensor_id(), control);
}

void SharedRoom::on_nudge(const pb::NamedNudge& nudge) {
  const wpb::SensorEntry* entry = entry_of(nudge.sensor());
  if (!is_owner() || !is_welcome_ || entry == nullptr) return;
  wpb::Control control;
  control.mutable_nudge()->set_sensor_id(entry->id());
  *control.mutable_nudge()->mutable_world_from_depth() = nudge.world_from_depth();
  if (wire::check_control(control)) context_.rooms.on_control(*aligner_, control);
}

}  // namespace roomcast::hub::federation
