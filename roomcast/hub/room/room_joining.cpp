// SPDX-License-Identifier: Apache-2.0
// How clients join a Room, and which messages they get on joining.
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/core/assert.h"
#include "roomcast/hub/access/author_tag.h"
#include "roomcast/hub/room/pose_rules.h"
#include "roomcast/hub/room/room.h"
#include "roomcast/wire/limits.h"
#include "roomcast/wire/pose_message.h"
#include "roomcast/wire/sighting_request.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

// Distinguishable with red-green blindness: the palette of Okabe and Ito without black and grey.
constexpr std::array<std::uint32_t, 7> kViewerColors = {0xE69F00, 0x56B4E9, 0x009E73, 0xF0E442,
                                                        0x0072B2, 0xD55E00, 0xCC79A7};

/// The name of an online sensor is reserved: it can be taken over only with the same token, or with
/// one that permits taking over the name. So one sensor cannot send as another.
bool may_replace(const RoomSensor& sensor, const Entry& entry) {
  return !sensor.connection || sensor.token_id == entry.token_id || entry.takes_over_name;
}

}  // namespace

RoomActions Room::join(ConnectionId from, const pb::Join& join, const Entry& entry, RoomTime now) {
  ROOMCAST_ASSERT(sensors_.find(from) == nullptr && !viewers_.contains(from) &&
                  playback_.find(from) == nullptr);
  RoomActions out;
  switch (join.role_case()) {
    case pb::Join::kSensor:
      join_sensor(from, join, entry, now, out);
      break;
    case pb::Join::kAligner:
      join_aligner(from, entry, now, out);
      break;
    case pb::Join::kModeler:
      join_modeler(from, entry, now, out);
      break;
    default:
      if (join.viewer().plays().empty())
        join_viewer(from, join, entry, now, out);
      else
        join_player(from, join, entry, now, out);
  }
  const bool is_in = sensors_.find(from) != nullptr || viewers_.contains(from);
  if (is_in && other_hubs_.has_other_hubs()) out.push_back(SendControl{{from}, other_hubs_});
  update_demand(now, out);
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
  if (!evict_for(join.name())) {
    out = refuse(
        from, pb::ERROR_ROOM_FULL,
        "this room has " + std::to_string(settings_.max_sensors) +
            " sensors that are connected or have a stored pose; its admin can forget one that is "
            "gone",
        now);
    return;
  }
  const bool was_here = sensors_.find(join.name()) != nullptr;
  RoomSensor* sensor = known_or_new_sensor(join.name(), out);
  ROOMCAST_ASSERT(sensor != nullptr);  // evict_for() left a free ID
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
  sensor->may_speak = entry.may_speak;
  sensor->has_spoken = false;
  sensor->is_at_other_hub = entry.other_hub != 0;
  sensor->description = join.sensor();
  sensor->key_pace = sensor->small_key_pace = {};  // its first frame is a key frame anyway
  sensor->stats.newest_seq.reset();
  sensor->bundle.reset();
  sensor->coarse_depth.reset();
  if (was_here && sensor->pose.is_estimated()) {
    doubt(sensor->pose);
    sensor->valid_from_bundle = sensor->bundles + 1;
  }
  take_given(join.sensor(), sensor->pose);
  sets_.remove_sensor(sensor->id);
  sets_.add_sensor(sensor->id, join.sensor().fps(), entry.other_hub);

  pb::Control welcome = welcome_message(entry);
  welcome.mutable_welcome()->set_sensor_id(sensor->id.value);
  welcome.mutable_welcome()->set_may_speak(entry.may_speak);
  out.push_back(AcceptConnection{from, Role::kSensor});
  out.push_back(SendControl{{from}, std::move(welcome)});
  out.emplace_back(RestartSensor{sensor->id});
  sensor->told = sensor->wanted = {};
  sensor->told.set_wanted(true);  // as a sensor assumes until it is told otherwise
  sensor->told_depth_scale = 1;
  views_.forget_sensor(sensor->id);
  tell_depth_scale(*sensor, out);
  if (wire::wants_any(wanted_sightings_)) {
    pb::Control request;
    *request.mutable_sighting_request() = wanted_sightings_;
    out.push_back(SendControl{{from}, std::move(request)});
  }
  send_roster(now, out);
  send_closed_sets(now, out);
}

/// Restarts the count of missed frames. Other hubs send no frames while nobody here watches; these
/// frames must not count as missed.
void Room::forget_newest_frames() {
  for (RoomSensor& sensor : sensors_.all()) sensor.stats.newest_seq.reset();
}

bool Room::is_full() const {
  return viewers_.size() + playback_.count() >= settings_.max_viewers;
}

RoomActions Room::refuse_as_full(ConnectionId from, RoomTime now) {
  return refuse(from, pb::ERROR_ROOM_FULL,
                "this room holds " + std::to_string(settings_.max_viewers) + " viewers and is full",
                now);
}

void Room::join_viewer(ConnectionId from, const pb::Join& join, const Entry& entry, RoomTime now,
                       RoomActions& out) {
  if (is_full()) {
    out = refuse_as_full(from, now);
    return;
  }
  pb::Control welcome = welcome_message(entry);
  welcome.mutable_welcome()->set_may_place(entry.may_place);
  welcome.mutable_welcome()->set_may_record(entry.may_record);
  welcome.mutable_welcome()->set_may_export(entry.may_share);
  welcome.mutable_welcome()->set_may_speak(entry.may_speak);
  const std::uint64_t author_tag = author_tag_of(settings_.name, join.viewer().author_key());
  welcome.mutable_welcome()->set_may_mark(entry.may_mark);
  welcome.mutable_welcome()->set_author_tag(author_tag);
  wire::write_transform(next_start_pose(), *welcome.mutable_welcome()->mutable_start_pose());
  welcome.mutable_welcome()->set_viewer_id(next_viewer_id_);

  if (viewers_.empty()) forget_newest_frames();
  poses_.resend_all();
  viewers_[from] = {.id = ViewerId{next_viewer_id_},
                    .name = join.name(),
                    .color_rgb = kViewerColors[next_viewer_id_ % kViewerColors.size()],
                    .may_nudge = entry.may_place,
                    .may_mark = entry.may_mark,
                    .records = join.viewer().records(),
                    .relays = join.viewer().relays(),
                    .may_speak = entry.may_speak,
                    .hears = join.viewer().hears(),
                    .token_id = entry.token_id,
                    .author_tag = author_tag};
  ++next_viewer_id_;
  out.push_back(AcceptConnection{from, join.viewer().relays() ? Role::kHub : Role::kViewer});
  out.push_back(SendControl{{from}, std::move(welcome)});
  if (!send_roster_when_due(now, out)) out.push_back(SendControl{{from}, roster_message()});
  add_voice(from, viewers_[from], out);
  tell_marks(from, out);
  for (RoomSensor& sensor : sensors_.all()) {
    if (sensor.connection && sensor.key_pace.request(now)) ask_for_key(sensor, out);
  }
}

void Room::join_aligner(ConnectionId from, const Entry& entry, RoomTime now, RoomActions& out) {
  if (aligners_.size() >= wire::kMaxAligners) {
    out = refuse(from, pb::ERROR_ROOM_FULL, "this room has as many aligners as it may have", now);
    return;
  }
  aligners_.push_back(from);
  if (entry.is_backplane) {
    backplane_aligners_.push_back(from);
    poses_.resend_all();
  }
  out.push_back(AcceptConnection{from, Role::kAligner});
  out.push_back(SendControl{{from}, welcome_message(entry)});
  out.push_back(SendControl{{from}, roster_message()});
  for (const RoomSensor& sensor : sensors_.all()) {
    if (sensor.connection && sensor.bundle) out.push_back(SendControl{{from}, *sensor.bundle});
  }
}

/// A modeler is nobody in the room: no sensor sends for it, and it is in no roster.
void Room::join_modeler(ConnectionId from, const Entry& entry, RoomTime now, RoomActions& out) {
  if (modelers_.size() >= wire::kMaxModelers) {
    out = refuse(from, pb::ERROR_ROOM_FULL, "this room has as many modelers as it may have", now);
    return;
  }
  modelers_.push_back(from);
  out.push_back(AcceptConnection{from, Role::kModeler});
  out.push_back(SetDetails{from, SensorDetails(wire::kMaxSensors, Detail::kKeyFrames)});
  out.push_back(SendControl{{from}, welcome_message(entry)});
  out.push_back(SendControl{{from}, roster_message()});
}

/// Removes offline sensors that have no estimated pose, oldest first, until a sensor of this name
/// fits; so invented names cannot fill the room. False: the room is full of sensors that are online
/// or have an estimated pose.
bool Room::evict_for(const std::string& name) {
  if (sensors_.find(name) != nullptr) return true;
  while (sensors_.count() >= settings_.max_sensors || sensors_.would_displace(name)) {
    const RoomSensor* gone = sensors_.longest_gone();
    if (gone == nullptr) return sensors_.count() < settings_.max_sensors;
    voices_.forget(wire::speaker_of(gone->id));
    sensors_.remove(*gone);
  }
  return true;
}

RoomSensor* Room::known_or_new_sensor(const std::string& name, RoomActions& out) {
  if (RoomSensor* known = sensors_.find(name)) return known;
  RoomSensor* added = sensors_.add(name);
  if (added == nullptr) return nullptr;
  const KnownSensor* earlier = sensors_.remembered(name);
  const auto pose = earlier != nullptr ? earlier->pose : std::nullopt;
  if (pose && restores_poses_) added->pose = *pose;
  if (earlier == nullptr || earlier->id != added->id) {
    out.push_back(SaveSensors{{{name, added->id, pose}}});
  }
  return added;
}

RigidTransform Room::next_start_pose() const {
  if (const auto& positions = settings_.start_positions; !positions.empty()) {
    return world_from_viewer(positions[viewers_.size() % positions.size()]);
  }
  std::vector<RigidTransform> placed;
  for (const RoomSensor& sensor : sensors_.all()) {
    if (sensor.pose.is_placed()) placed.push_back(sensor.pose.world_from_depth);
  }
  if (placed.empty()) {
    for (const RoomSensor& sensor : sensors_.all()) placed.push_back(sensor.pose.world_from_depth);
  }
  return start_pose(placed, viewers_.size());
}

}  // namespace roomcast::hub
