// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/room.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "roomcast/hub/room/interference_advice.h"
#include "roomcast/wire/limits.h"
#include "roomcast/wire/pose_message.h"
#include "roomcast/wire/sighting_request.h"

namespace roomcast::hub {

namespace pb = wire::pb;

Room::Room(RoomSettings settings, std::string hub_version, bool restores_poses)
    : settings_(std::move(settings)),
      hub_version_(std::move(hub_version)),
      restores_poses_(restores_poses) {}

/// Aligners may, too: the backplane joins as an aligner and forwards the nudges of other hubs.
bool Room::may_nudge(ConnectionId from) const {
  const auto viewer = viewers_.find(from);
  if (viewer != viewers_.end()) return viewer->second.may_nudge;
  return std::ranges::find(aligners_, from) != aligners_.end();
}

RoomActions Room::control(ConnectionId from, const pb::Control& message, RoomTime now) {
  if (playback_.find(from) != nullptr) return control_of_player(from, message, now);
  RoomActions out;
  const auto viewer = viewers_.find(from);
  RoomSensor* const sensor = sensors_.find(from);
  switch (message.message_case()) {
    case pb::Control::kCalibrationBundle:
      if (sensor == nullptr) break;
      keep_bundle(*sensor, message.calibration_bundle(), now, out);
      return out;
    case pb::Control::kSensorMoved:
      if (sensor == nullptr) break;
      lose_place(*sensor, now, out);
      return out;
    case pb::Control::kSensorHealth:
      if (sensor == nullptr) break;
      sensor->health = message.sensor_health();
      return out;
    case pb::Control::kCoarseDepth:
      if (sensor == nullptr) break;
      sensor->coarse_depth = message.coarse_depth();
      if (sensor->gone.update(message.coarse_depth(), now)) {
        for (RoomSensor& any : sensors_.all()) any.gone.expect_changes();
      }
      sensor->surface_pose.reset();
      follow_surface(*sensor);
      return out;
    case pb::Control::kSightings:
    case pb::Control::kDepthInstant:
      if (sensor == nullptr) break;
      pass_to_aligners(with_sensor_id(*sensor, message), out);
      return out;
    case pb::Control::kSightingRequest:
      if (std::ranges::find(aligners_, from) == aligners_.end()) break;
      ask_for_sightings(message.sighting_request(), out);
      return out;
    case pb::Control::kNudge:
      if (!may_nudge(from)) {
        return refuse(from, pb::ERROR_UNEXPECTED,
                      "to move a sensor takes an admin's token (roomcast token --role admin)", now);
      }
      pass_to_aligners(message, out);
      return out;
    case pb::Control::kPlacements:
      if (std::ranges::find(aligners_, from) == aligners_.end()) break;
      take_placements(message.placements(), now, out);
      return out;
    case pb::Control::kOtherHubs:
      if (std::ranges::find(aligners_, from) == aligners_.end()) break;
      name_other_hubs(message, out);
      return out;
    case pb::Control::kKeyRequest:
      if (viewer == viewers_.end() && std::ranges::find(modelers_, from) == modelers_.end()) break;
      return key_needed(wire_id(message.key_request().sensor_id()), now);
    case pb::Control::kViewerPose:
      if (viewer == viewers_.end()) break;
      poses_.set(viewer->second.id, message.viewer_pose(), now);
      culling_.viewer_moved(from, message.viewer_pose(), now);
      views_.expect_change(now);
      return out;
    case pb::Control::kPeopleHere:
      if (!may_report_people(from)) break;
      return take_people(from, message.people_here(), now);
    case pb::Control::kViewerPoses:
      if (!may_report_people(from)) break;
      take_poses(from, message.viewer_poses(), now);
      return out;
    case pb::Control::kMark:
      if (viewer == viewers_.end()) break;
      return take_mark(from, viewer->second, message.mark(), now);
    case pb::Control::kRemoveMarks:
      if (viewer == viewers_.end()) break;
      return remove_marks(from, viewer->second, message.remove_marks(), now);
    case pb::Control::kGuide:
      if (viewer == viewers_.end()) break;
      if (!viewer->second.may_nudge) {
        return refuse(from, pb::ERROR_UNEXPECTED, "to guide everybody takes an admin's token", now);
      }
      return set_guide(viewer->second.id, message.guide().on());
    case pb::Control::kViewerStats:
      if (viewer == viewers_.end()) break;
      viewer->second.reported_stats = message.viewer_stats();
      return out;
    case pb::Control::MESSAGE_NOT_SET:
      return out;  // a message of a later protocol version
    default:
      break;
  }
  return refuse(from, pb::ERROR_UNEXPECTED,
                "this control message may not be sent to a hub by this kind of client", now);
}

/// To all clients but aligners, which belong to this hub.
void Room::name_other_hubs(const pb::Control& message, RoomActions& out) {
  other_hubs_ = message;
  std::vector<ConnectionId> to = viewer_connections();
  for (const RoomSensor& sensor : sensors_.all()) {
    if (sensor.connection) to.push_back(*sensor.connection);
  }
  if (!to.empty()) out.push_back(SendControl{std::move(to), message});
}

RoomActions Room::change(RoomSettings settings, RoomTime now) {
  const bool recorded_voices = std::exchange(settings_, std::move(settings)).record_voices;
  RoomActions out;
  if (recorded_voices != settings_.record_voices) change_recorded_voices(now, out);
  update_demand(now, out);
  return out;
}

RoomActions Room::forget(const std::string& name, RoomTime now) {
  RoomActions out;
  const RoomSensor* sensor = sensors_.find(name);
  if (sensor != nullptr && sensor->connection) return out;
  if (sensor != nullptr) voices_.forget(wire::speaker_of(sensor->id));
  if (sensors_.forget(name)) send_roster(now, out);
  return out;
}

RoomActions Room::leave(ConnectionId from, RoomTime now) {
  RoomActions out;
  if (RoomSensor* sensor = sensors_.find(from)) {
    sensors_.disconnect(*sensor);
    voices_.end(wire::speaker_of(sensor->id));
    sets_.remove_sensor(sensor->id);
    sensor->coarse_depth.reset();
    send_roster(now, out);
    send_closed_sets(now, out);
  } else if (const auto viewer = viewers_.find(from); viewer != viewers_.end()) {
    const ViewerId id = viewer->second.id;
    poses_.forget(id);
    voices_.forget(id);
    culling_.forget_viewer(from);
    viewers_.erase(viewer);
    out = set_guide(id, false);
    forget_people(remote_presence_.forget(from));
    send_roster_when_due(now, out);
  } else if (!playback_.remove(from)) {
    std::erase(aligners_, from);
    std::erase(backplane_aligners_, from);
    std::erase(modelers_, from);
    if (forget_people(remote_presence_.forget(from))) send_roster_when_due(now, out);
    if (aligners_.empty() && wire::wants_any(wanted_sightings_)) ask_for_sightings({}, out);
  }
  update_demand(now, out);
  return out;
}

RoomActions Room::tick(RoomTime now) {
  RoomActions out;
  send_closed_sets(now, out);
  for (RoomSensor& sensor : sensors_.all()) {
    if (!sensor.connection) continue;
    if (sensor.key_pace.due(now)) ask_for_key(sensor, out);
    if (sensor.small_key_pace.due(now)) ask_for_key(sensor, out, true);
  }
  if (auto poses = poses_.take(now)) {
    out.push_back(SendControl{readers_of_poses(), *std::move(poses)});
  }
  send_voices(now, out);
  playback_.send_voices(now, out);
  cull(now, out);
  if (roster_changed_ && now >= next_roster_) send_roster(now, out);
  tell_demands_when_due(now, out);
  tell_views(now, out);
  return out;
}

std::optional<RoomTime> Room::next_tick() const {
  std::optional<RoomTime> next = sets_.next_deadline();
  const auto consider = [&](std::optional<RoomTime> time) {
    if (time && (!next || *time < *next)) next = time;
  };
  for (const RoomSensor& sensor : sensors_.all()) {
    if (!sensor.connection) continue;
    consider(sensor.key_pace.next());
    consider(sensor.small_key_pace.next());
  }
  consider(poses_.next());
  consider(voices_.next());
  consider(playback_.next());
  consider(culling_.next());
  consider(views_.next());
  consider(demand_.next());
  consider(uplink_.next());
  if (roster_changed_) consider(next_roster_);
  return next;
}

/// Sends the roster at once. Sensor changes need this: a viewer must have a sensor's calibration
/// before its frames. If people have changed, all poses are sent again, because viewers may have
/// received poses of people whom no roster had named yet.
void Room::send_roster(RoomTime now, RoomActions& out) {
  place_unplaced_in_row();
  for (RoomSensor& sensor : sensors_.all()) follow_surface(sensor);
  views_.expect_change(now);
  const bool people_changed = std::exchange(roster_changed_, false);
  if (viewers_.empty() && aligners_.empty() && modelers_.empty()) return;
  next_roster_ = now + wire::kRosterInterval;
  if (people_changed) poses_.resend_all();
  out.push_back(SendControl{readers_of_roster(), roster_message()});
}

/// Sends the roster with who joined or left, at most once per wire::kRosterInterval. Otherwise a
/// group that joins together would cause one roster to everybody per person. False: the roster is
/// sent later.
bool Room::send_roster_when_due(RoomTime now, RoomActions& out) {
  roster_changed_ = true;
  if (now < next_roster_) return false;
  send_roster(now, out);
  return true;
}

pb::Control Room::roster_message() {
  ++roster_revision_;
  pb::Control control;
  *control.mutable_roster() = roster();
  return control;
}

std::vector<ConnectionId> Room::viewer_connections() const {
  std::vector<ConnectionId> connections;
  connections.reserve(viewers_.size());
  for (const auto& [connection, viewer] : viewers_) connections.push_back(connection);
  return connections;
}

std::vector<ConnectionId> Room::readers_of_roster() const {
  std::vector<ConnectionId> connections = viewer_connections();
  connections.insert(connections.end(), aligners_.begin(), aligners_.end());
  connections.insert(connections.end(), modelers_.begin(), modelers_.end());
  return connections;
}

std::vector<ConnectionId> Room::connections() const {
  std::vector<ConnectionId> connections = readers_of_roster();
  for (const RoomSensor& sensor : sensors_.all()) {
    if (sensor.connection) connections.push_back(*sensor.connection);
  }
  for (const auto& [connection, player] : playback_.all()) connections.push_back(connection);
  return connections;
}

pb::Roster Room::roster() const {
  pb::Roster roster;
  roster.set_revision(roster_revision_);
  roster.set_fps(sets_.fps());
  for (const RoomSensor& sensor : sensors_.all()) {
    auto& entry = *roster.add_sensors();
    entry.set_id(sensor.id.value);
    entry.set_name(sensor.name);
    entry.set_online(sensor.connection.has_value());
    *entry.mutable_calibration() = sensor.description.calibration();
    wire::write_pose(sensor.pose, entry);
    entry.set_fps(sensor.description.fps());
  }
  for (const auto& [connection, viewer] : viewers_) {
    auto& entry = *roster.add_viewers();
    entry.set_id(viewer.id.value);
    entry.set_name(viewer.name);
    entry.set_color_rgb(viewer.color_rgb);
    entry.set_relays(viewer.relays);
    entry.set_records(viewer.records);
    entry.set_records_voices(viewer.records && may_hear(viewer));
  }
  remote_presence_.write_to(roster);
  return roster;
}

RoomStats Room::stats() const {
  RoomStats stats = set_stats_;
  stats.room = settings_.name;
  stats.frames_wanted = demand_.wanted();
  stats.speakers = voices_.speaker_count();
  for (const RoomSensor& sensor : sensors_.all()) {
    SensorStats& entry = stats.sensors.emplace_back(sensor.stats);
    entry.id = sensor.id;
    entry.name = sensor.name;
    entry.online = sensor.connection.has_value();
    entry.connection = sensor.connection.value_or(ConnectionId{});
    entry.token_id = sensor.connection ? sensor.token_id : "";
    entry.pose = sensor.pose;
    entry.interference = interference_of(sensor, sensors_);
    entry.has_microphone = sensor.has_spoken;
    entry.speaks = voices_.is_speaking(wire::speaker_of(sensor.id));
    entry.is_unseen = sensor.told.unseen();
    entry.share_mbit = sensor.told.mbit();
    entry.muted = voices_.is_muted(wire::speaker_of(sensor.id));
    if (entry.online && sensor.description.has_settings())
      entry.settings = sensor.description.settings();
  }
  for (const auto& [connection, viewer] : viewers_) {
    stats.viewers.push_back({.id = viewer.id,
                             .name = viewer.name,
                             .connection = connection,
                             .token_id = viewer.token_id,
                             .records = viewer.records,
                             .may_speak = viewer.may_speak,
                             .speaks = voices_.is_speaking(viewer.id),
                             .muted = voices_.is_muted(viewer.id),
                             .shown_fps = viewer.reported_stats.shown_fps(),
                             .latency_ms = viewer.reported_stats.latency_ms(),
                             .small_sensors = viewer.small.size()});
  }
  add_players_to(stats);
  std::ranges::sort(stats.viewers, {}, &ViewerStats::id);
  return stats;
}

RoomActions Room::refuse(ConnectionId from, pb::ErrorCode code, std::string sentence,
                         RoomTime now) {
  RoomActions out = leave(from, now);
  out.push_back(Disconnect{from, code, std::move(sentence)});
  return out;
}

}  // namespace roomcast::hub
