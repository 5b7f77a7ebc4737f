// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/upstream/mirrored_room.h"

#include <utility>
#include <vector>

namespace roomcast::hub::federation {

namespace wpb = wire::pb;

namespace {

constexpr std::uint64_t kOtherHub = 1;  // there is only one other hub

}  // namespace

MirroredRoom::MirroredRoom(std::string room, std::string token, hub::BackplaneEvents& here,
                           NewConnection new_connection)
    : room_(std::move(room)),
      token_(std::move(token)),
      here_(here),
      new_connection_(std::move(new_connection)),
      sensors_(kOtherHub, room_, token_, here_, new_connection_) {}

// ---- from the other hub

std::vector<wpb::Control> MirroredRoom::on_welcome(std::uint32_t viewer_id) {
  viewer_id_ = viewer_id;
  std::vector<wpb::Control> first(2);
  *first[0].mutable_people_here() = people_here_.people();
  *first[1].mutable_viewer_poses() = people_here_.newest_poses();
  return first;
}

void MirroredRoom::on_poses(const wpb::ViewerPoses& poses) {
  if (!aligner_is_welcome_) return;
  wpb::Control control;
  *control.mutable_viewer_poses() = poses;
  here_.on_control(*aligner_, control);
}

void MirroredRoom::on_roster(const wpb::Roster& roster) {
  if (!aligner_) join_as_aligner();
  std::vector<hub::federation::SensorThere> online;
  for (const auto& entry : roster.sensors()) {
    if (entry.online()) online.push_back({.entry = entry});
  }
  sensors_.set_online(online);
  place_sensors();
  people_there_ = hub::federation::people_there(roster, viewer_id_);
  show_people();
}

void MirroredRoom::show_people() {
  if (!aligner_is_welcome_) return;
  if (const auto news = shown_presence_.update(people_there_)) here_.on_control(*aligner_, *news);
}

void MirroredRoom::join_as_aligner() {
  const hub::ConnectionPtr connection = new_connection_();
  aligner_ = connection->id();
  wpb::Join join;
  join.set_room(room_);
  join.set_token(token_);
  join.mutable_aligner();
  here_.on_join(
      {.connection = connection, .address = "another hub", .peer = "", .is_backplane = true}, join);
}

void MirroredRoom::on_hub_lost() {
  sensors_.on_hub_lost();
  people_there_.Clear();
  shown_presence_.forget();
  if (!aligner_) return;
  const ConnectionId aligner = *std::exchange(aligner_, std::nullopt);
  aligner_is_welcome_ = false;
  here_.on_left(aligner, {net::close_code::kGoingAway, "the other hub is gone"});
}

// ---- from the room here

std::optional<wpb::Control> MirroredRoom::on_room_message(ConnectionId to,
                                                          const wpb::Control& message) {
  if (to == aligner_) return on_aligner_message(message);
  auto request = sensors_.on_room_message(to, message);
  if (message.has_welcome()) place_sensors();
  return request;
}

std::optional<wpb::Control> MirroredRoom::on_aligner_message(const wpb::Control& message) {
  wpb::Control report;
  if (message.has_welcome()) {
    aligner_is_welcome_ = true;
    shown_presence_.forget();
    place_sensors();
    show_people();
  } else if (message.has_roster() && people_here_.take(message.roster())) {
    *report.mutable_people_here() = people_here_.people();
    return report;
  } else if (message.has_viewer_poses()) {
    *report.mutable_viewer_poses() = people_here_.take(message.viewer_poses());
    if (report.viewer_poses().poses_size() > 0) return report;
  }
  return std::nullopt;
}

void MirroredRoom::place_sensors() {
  if (!aligner_is_welcome_) return;
  wpb::Control control;
  for (const auto& [there, sensor] : sensors_.all()) {
    const wpb::SensorEntry& entry = sensor.there.entry;
    if (!sensor.id || entry.placement() == wpb::PLACEMENT_GIVEN) continue;
    *control.mutable_placements()->add_sensors() = hub::federation::placement_of(entry, *sensor.id);
  }
  if (control.has_placements()) here_.on_control(*aligner_, control);
}

void MirroredRoom::on_removed(ConnectionId connection) {
  if (connection == aligner_) aligner_.reset(), aligner_is_welcome_ = false;
  sensors_.on_removed(connection);
}

}  // namespace roomcast::hub::federation
