// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room.h"

#include <algorithm>
#include <array>
#include <utility>

#include "roomcast/core/assert.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

// Told apart by people with red-green blindness too: Okabe and Ito's palette without black and
// grey.
constexpr std::array<std::uint32_t, 7> kViewerColors = {0xE69F00, 0x56B4E9, 0x009E73, 0xF0E442,
                                                        0x0072B2, 0xD55E00, 0xCC79A7};

/// One sensor cannot send as another: the name of one that is online is its own.
bool may_replace(const RoomSensor& sensor, const Entry& entry) {
  return !sensor.connection || sensor.token_id == entry.token_id || entry.takes_over_name;
}

}  // namespace

Room::Room(RoomSettings settings, std::string hub_version, bool recalls_poses)
    : settings_(std::move(settings)),
      hub_version_(std::move(hub_version)),
      recalls_poses_(recalls_poses) {}

RoomActions Room::join(ConnectionId from, const pb::Join& join, const Entry& entry, RoomTime now) {
  ROOMCAST_ASSERT(sensors_.find(from) == nullptr && !viewers_.contains(from));
  RoomActions out;
  switch (join.role_case()) {
    case pb::Join::kSensor:
      join_sensor(from, join, entry, now, out);
      break;
    case pb::Join::kAligner:
      join_aligner(from, entry, now, out);
      break;
    default:
      join_viewer(from, join, entry, now, out);
  }
  return out;
}

pb::Control Room::welcome_message(const Entry& entry) const {
  pb::Control control;
  pb::Welcome& welcome = *control.mutable_welcome();
  welcome.set_room(settings_.name);
  welcome.set_hub_version(hub_version_);
  welcome.set_token(entry.new_token);
  return control;
}

void Room::join_sensor(ConnectionId from, const pb::Join& join, const Entry& entry, RoomTime now,
                       RoomActions& out) {
  if (sensors_.find(join.name()) == nullptr && sensors_.count() >= settings_.max_sensors) {
    out = refuse(from, pb::ERROR_ROOM_FULL,
                 "this room knows " + std::to_string(settings_.max_sensors) + " sensors already",
                 now);
    return;
  }
  RoomSensor* sensor = known_or_new_sensor(join.name(), out);
  ROOMCAST_ASSERT(sensor != nullptr);  // there are ids for kMaxSensors
  if (!may_replace(*sensor, entry)) {
    out = refuse(from, pb::ERROR_WRONG_ROLE,
                 "another sensor is here as \"" + sensor->name + "\"; choose another --name", now);
    return;
  }
  if (sensor->connection) {
    out.push_back(Disconnect{*sensor->connection, pb::ERROR_REPLACED,
                             "sensor \"" + sensor->name + "\" has joined again from elsewhere"});
  }
  sensors_.connect(*sensor, from);
  sensor->token_id = entry.token_id;
  sensor->description = join.sensor();
  sensor->key_pace = {};  // its first frame is a key frame anyway
  sensor->bundle.reset();
  sensor->place.give(join.sensor());
  sets_.remove_sensor(sensor->id);
  sets_.add_sensor(sensor->id, join.sensor().fps());

  pb::Control welcome = welcome_message(entry);
  welcome.mutable_welcome()->set_sensor_id(sensor->id.value);
  out.push_back(AcceptConnection{from, Role::kSensor});
  out.push_back(SendControl{{from}, std::move(welcome)});
  out.emplace_back(RestartSensor{sensor->id});
  if (wanted_sightings_.heads() || wanted_sightings_.tags()) {
    pb::Control request;
    *request.mutable_sighting_request() = wanted_sightings_;
    out.push_back(SendControl{{from}, std::move(request)});
  }
  announce(now, out);
  send_closed_sets(now, out);
}

void Room::join_viewer(ConnectionId from, const pb::Join& join, const Entry& entry, RoomTime now,
                       RoomActions& out) {
  if (viewers_.size() >= settings_.max_viewers) {
    out = refuse(
        from, pb::ERROR_ROOM_FULL,
        "this room holds " + std::to_string(settings_.max_viewers) + " viewers and is full", now);
    return;
  }
  pb::Control welcome = welcome_message(entry);
  welcome.mutable_welcome()->set_may_place(entry.may_place);
  welcome.mutable_welcome()->set_may_record(entry.may_record);
  welcome.mutable_welcome()->set_may_export(entry.may_share);
  const Matrix4 pose = next_start_pose();
  welcome.mutable_welcome()->mutable_start_pose()->Assign(pose.begin(), pose.end());
  welcome.mutable_welcome()->set_viewer_id(next_viewer_id_);

  poses_.tell_all_again();
  viewers_[from] = {.id = ViewerId{next_viewer_id_},
                    .name = join.name(),
                    .color_rgb = kViewerColors[next_viewer_id_ % kViewerColors.size()],
                    .may_nudge = entry.may_place,
                    .records = join.viewer().records(),
                    .token_id = entry.token_id};
  ++next_viewer_id_;
  out.push_back(AcceptConnection{from, Role::kViewer});
  out.push_back(SendControl{{from}, std::move(welcome)});
  if (!announce_in_time(now, out)) out.push_back(SendControl{{from}, roster_message()});
  for (RoomSensor& sensor : sensors_.all()) {
    if (sensor.connection && sensor.key_pace.request(now)) ask_for_key(sensor, out);
  }
}

void Room::join_aligner(ConnectionId from, const Entry& entry, RoomTime now, RoomActions& out) {
  if (aligners_.size() >= wire::kMaxAligners) {
    out = refuse(from, pb::ERROR_ROOM_FULL, "this room has aligners enough", now);
    return;
  }
  aligners_.push_back(from);
  out.push_back(AcceptConnection{from, Role::kAligner});
  out.push_back(SendControl{{from}, welcome_message(entry)});
  out.push_back(SendControl{{from}, roster_message()});
  for (const RoomSensor& sensor : sensors_.all()) {
    if (sensor.connection && sensor.bundle) out.push_back(SendControl{{from}, *sensor.bundle});
  }
}

RoomSensor* Room::known_or_new_sensor(const std::string& name, RoomActions& out) {
  if (RoomSensor* known = sensors_.find(name)) return known;
  RoomSensor* added = sensors_.add(name);
  if (added == nullptr) return nullptr;
  const KnownSensor* earlier = sensors_.remembered(name);
  const auto pose = earlier != nullptr ? earlier->pose : std::nullopt;
  if (pose && recalls_poses_) added->place.recall(*pose);
  if (earlier == nullptr || earlier->id != added->id) {
    out.push_back(KeepSensors{{{name, added->id, pose}}});
  }
  return added;
}

RoomActions Room::control(ConnectionId from, const pb::Control& message, RoomTime now) {
  RoomActions out;
  const auto viewer = viewers_.find(from);
  RoomSensor* const sensor = sensors_.find(from);
  switch (message.message_case()) {
    case pb::Control::kCalibrationBundle:
      if (sensor == nullptr) break;
      keep_bundle(*sensor, message.calibration_bundle(), out);
      return out;
    case pb::Control::kSensorMoved:
      if (sensor == nullptr) break;
      lose_place(*sensor, now, out);
      return out;
    case pb::Control::kSightings: {
      if (sensor == nullptr) break;
      pb::Control passed = message;
      passed.mutable_sightings()->set_sensor_id(sensor->id.value);
      pass_to_aligners(std::move(passed), out);
      return out;
    }
    case pb::Control::kSightingRequest:
      if (std::ranges::find(aligners_, from) == aligners_.end()) break;
      ask_for_sightings(message.sighting_request(), out);
      return out;
    case pb::Control::kNudge:
      if (viewer == viewers_.end() || !viewer->second.may_nudge) break;
      pass_to_aligners(message, out);
      return out;
    case pb::Control::kPlacements:
      if (std::ranges::find(aligners_, from) == aligners_.end()) break;
      take_placements(message.placements(), now, out);
      return out;
    case pb::Control::kKeyRequest:
      if (viewer == viewers_.end()) break;
      return key_needed(wire_id(message.key_request().sensor_id()), now);
    case pb::Control::kViewerPose:
      if (viewer == viewers_.end()) break;
      poses_.set(viewer->second.id, message.viewer_pose(), now);
      return out;
    case pb::Control::kViewerStats:
      if (viewer == viewers_.end()) break;
      viewer->second.told = message.viewer_stats();
      return out;
    case pb::Control::MESSAGE_NOT_SET:
      return out;  // of a later version
    default:
      break;
  }
  return refuse(from, pb::ERROR_UNEXPECTED,
                "this control message may not be sent to a hub by this kind of client", now);
}

RoomActions Room::frame(ConnectionId from, const wire::FrameHeader& header,
                        net::MessageBuffer message, RoomTime now) {
  RoomSensor* const sensor = sensors_.find(from);
  if (sensor == nullptr) {
    return refuse(from, pb::ERROR_UNEXPECTED, "only a sensor that has joined may send frames", now);
  }
  if (header.sensor != sensor->id) {
    return refuse(
        from, pb::ERROR_UNEXPECTED,
        "this frame carries the id of another sensor than " + std::to_string(sensor->id.value),
        now);
  }
  if (header.capture_time > now + wire::kMaxCaptureAhead) {
    return refuse(from, pb::ERROR_MALFORMED,
                  "this frame was captured in the future: synchronise the clock first", now);
  }
  if (header.key) sensor->key_pace.key_frame_came();
  count_frame(header, message.size(), now, sensor->stats);
  RoomActions out;
  if (!sets_.add_frame(header, std::move(message), now)) return out;
  send_closed_sets(now, out);
  return out;
}

RoomActions Room::key_needed(SensorId id, RoomTime now) {
  RoomActions out;
  RoomSensor* const sensor = sensors_.find(id);  // none: a viewer with an old roster, or a joker
  if (sensor == nullptr || !sensor->connection) return out;
  if (sensor->key_pace.request(now)) ask_for_key(*sensor, out);
  return out;
}

RoomActions Room::leave(ConnectionId from, RoomTime now) {
  RoomActions out;
  if (RoomSensor* sensor = sensors_.find(from)) {
    sensors_.disconnect(*sensor);
    sets_.remove_sensor(sensor->id);
    announce(now, out);
    send_closed_sets(now, out);
  } else if (const auto viewer = viewers_.find(from); viewer != viewers_.end()) {
    poses_.forget(viewer->second.id);
    viewers_.erase(viewer);
    announce_in_time(now, out);
  } else {
    std::erase(aligners_, from);
    if (aligners_.empty() && (wanted_sightings_.heads() || wanted_sightings_.tags()))
      ask_for_sightings({}, out);
  }
  return out;
}

RoomActions Room::tick(RoomTime now) {
  RoomActions out;
  send_closed_sets(now, out);
  for (RoomSensor& sensor : sensors_.all()) {
    if (sensor.connection && sensor.key_pace.due(now)) ask_for_key(sensor, out);
  }
  if (auto poses = poses_.take(now)) {
    out.push_back(SendControl{viewer_connections(), *std::move(poses)});
  }
  if (roster_is_news_ && now >= next_roster_) announce(now, out);
  return out;
}

std::optional<RoomTime> Room::next_tick() const {
  std::optional<RoomTime> next = sets_.next_deadline();
  const auto consider = [&](std::optional<RoomTime> time) {
    if (time && (!next || *time < *next)) next = time;
  };
  for (const RoomSensor& sensor : sensors_.all()) {
    if (sensor.connection) consider(sensor.key_pace.next());
  }
  consider(poses_.next());
  if (roster_is_news_) consider(next_roster_);
  return next;
}

void Room::ask_for_key(const RoomSensor& sensor, RoomActions& out) {
  pb::Control request;
  request.mutable_key_request()->set_sensor_id(sensor.id.value);
  out.push_back(SendControl{{*sensor.connection}, std::move(request)});
}

void Room::send_closed_sets(RoomTime now, RoomActions& out) {
  for (FrameSetPtr& set : sets_.take_closed(now)) {
    count_set(*set, sensors_.online_count(), set_stats_);
    if (!viewers_.empty()) out.emplace_back(SendSet{std::move(set)});
  }
}

/// For what concerns the pictures: nobody may get a sensor's frames before its calibration.
void Room::announce(RoomTime now, RoomActions& out) {
  roster_is_news_ = false;
  if (viewers_.empty() && aligners_.empty()) return;
  next_roster_ = now + wire::kRosterInterval;
  out.push_back(SendControl{readers_of_roster(), roster_message()});
}

/// For people who come and go: now, or with others a little later. When a whole class arrives, each
/// would otherwise be told of each. False: later.
bool Room::announce_in_time(RoomTime now, RoomActions& out) {
  roster_is_news_ = true;
  if (now < next_roster_) return false;
  announce(now, out);
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
  return connections;
}

std::vector<ConnectionId> Room::connections() const {
  std::vector<ConnectionId> connections = readers_of_roster();
  for (const RoomSensor& sensor : sensors_.all()) {
    if (sensor.connection) connections.push_back(*sensor.connection);
  }
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
    sensor.place.write_to(entry);
    entry.set_fps(sensor.description.fps());
  }
  for (const auto& [connection, viewer] : viewers_) {
    auto& entry = *roster.add_viewers();
    entry.set_id(viewer.id.value);
    entry.set_name(viewer.name);
    entry.set_color_rgb(viewer.color_rgb);
  }
  return roster;
}

RoomStats Room::stats() const {
  RoomStats stats = set_stats_;
  stats.room = settings_.name;
  for (const RoomSensor& sensor : sensors_.all()) {
    SensorStats& entry = stats.sensors.emplace_back(sensor.stats);
    entry.id = sensor.id;
    entry.name = sensor.name;
    entry.online = sensor.connection.has_value();
    entry.connection = sensor.connection.value_or(ConnectionId{});
    entry.token_id = sensor.connection ? sensor.token_id : "";
    entry.place = sensor.place;
  }
  for (const auto& [connection, viewer] : viewers_) {
    stats.viewers.push_back({.id = viewer.id,
                             .name = viewer.name,
                             .connection = connection,
                             .token_id = viewer.token_id,
                             .records = viewer.records,
                             .shown_fps = viewer.told.shown_fps(),
                             .latency_ms = viewer.told.latency_ms()});
  }
  std::ranges::sort(stats.viewers, {}, &ViewerStats::id);
  return stats;
}

Matrix4 Room::next_start_pose() const {
  if (const auto& positions = settings_.start_positions; !positions.empty()) {
    return world_from_viewer(positions[viewers_.size() % positions.size()]);
  }
  std::vector<Matrix4> placed;
  for (const RoomSensor& sensor : sensors_.all()) {
    if (sensor.place.placement == pb::PLACEMENT_UNPLACED) continue;
    placed.push_back(sensor.place.world_from_depth);
  }
  if (placed.empty()) {
    for (const RoomSensor& sensor : sensors_.all()) placed.push_back(sensor.place.world_from_depth);
  }
  return start_pose(placed, viewers_.size());
}

RoomActions Room::refuse(ConnectionId from, pb::ErrorCode code, std::string sentence,
                         RoomTime now) {
  RoomActions out = leave(from, now);
  out.push_back(Disconnect{from, code, std::move(sentence)});
  return out;
}

}  // namespace roomcast::hub
