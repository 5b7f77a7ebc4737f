// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/cluster/shared_room.h"

#include <algorithm>
#include <utility>

#include "roomcast/wire/control_check.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub::federation {
namespace {

namespace wpb = wire::pb;

const net::CloseReason kRejoins{net::close_code::kGoingAway, "joins again"};

wpb::Control control_with(const wpb::Roster& roster) {
  wpb::Control control;
  *control.mutable_roster() = roster;
  return control;
}

/// Checked like a roster of another hub: names, matrices and cameras can be used as they are.
bool is_legal(const pb::RoomNews& news) {
  wpb::Roster sensors, placed;
  for (const pb::SensorHere& sensor : news.sensors()) *sensors.add_sensors() = sensor.entry();
  for (const wpb::SensorEntry& entry : news.placed()) *placed.add_sensors() = entry;
  *sensors.mutable_viewers() = news.people();
  return wire::check_control(control_with(sensors)).ok() &&
         wire::check_control(control_with(placed)).ok();
}

}  // namespace

SharedRoom::SharedRoom(Context context) : context_(std::move(context)) {
  news_.set_hub(context_.own.value);
  news_.set_room(context_.room);
}

// ---- in the room here

void SharedRoom::ensure_joined() {
  if (!aligner_) join();
}

void SharedRoom::join() {
  const hub::ConnectionPtr connection = context_.new_connection();
  aligner_ = connection->id();
  wpb::Join join;
  join.set_room(context_.room);
  join.set_token(context_.token);
  join.set_name("other hubs");
  join.mutable_aligner();
  context_.rooms.on_join(
      {.connection = connection, .address = "other hubs", .peer = "", .is_backplane = true}, join);
}

void SharedRoom::leave() {
  is_welcome_ = false;
  if (aligner_) context_.rooms.on_left(*std::exchange(aligner_, std::nullopt), kRejoins);
}

void SharedRoom::on_room_message(ConnectionId to, const wpb::Control& message) {
  if (to == aligner_) {
    is_welcome_ |= message.has_welcome();
    if (message.has_welcome()) {
      shown_presence_.forget();
      show_people();
    }
    if (message.has_roster()) return take_roster(message.roster());
    if (message.has_viewer_poses())
      return broadcast_poses(people_here_.take(message.viewer_poses()));
    return forward_to_owner(message);
  }
  for (auto& [id, hub] : others_) {
    const auto request = hub.sensors.on_room_message(to, message);
    const bool is_its = std::ranges::any_of(
        hub.sensors.all(), [to](const auto& sensor) { return sensor.second.connection == to; });
    if (!is_its) continue;
    pb::ToHub out = message_to_hub();
    if (request) *out.mutable_key_request() = request->key_request();
    if (message.has_sighting_request() && is_owner()) {
      *out.mutable_sightings_wanted()->mutable_request() = message.sighting_request();
    }
    if (out.what_case() != pb::ToHub::WHAT_NOT_SET) context_.out.send_to(id, out);
    if (message.has_welcome() && is_owner()) request_bundles(id);
    return;
  }
}

void SharedRoom::on_removed(ConnectionId connection) {
  if (connection == aligner_) aligner_.reset(), is_welcome_ = false;
  for (auto& [id, hub] : others_) hub.sensors.on_removed(connection);
}

void SharedRoom::sensor_joins(const std::string& name, const std::string& token_id) {
  if (claims_.size() > 2 * wire::kMaxSensors) forget_claims();
  claims_[name] = {winner(name).number + 1, token_id};
}

/// Forgets the claims of sensors that the room did not accept.
void SharedRoom::forget_claims() {
  std::erase_if(claims_, [this](const auto& claim) { return entry_of(claim.first) == nullptr; });
}

void SharedRoom::take_roster(const wpb::Roster& roster) {
  roster_ = roster;
  people_here_.take(roster);
  publish_news();
  place_sensors();
}

const wpb::SensorEntry* SharedRoom::entry_of(const std::string& sensor) const {
  const auto found = std::ranges::find_if(
      roster_.sensors(), [&](const auto& entry) { return entry.name() == sensor; });
  return found == roster_.sensors().end() ? nullptr : &*found;
}

// ---- claims to sensor names

bool SharedRoom::is_mirrored(const std::string& sensor) const {
  return std::ranges::any_of(others_,
                             [&](const auto& other) { return other.second.sensors.has(sensor); });
}

bool SharedRoom::is_local(std::uint32_t sensor_id) const {
  return std::ranges::any_of(news_.sensors(), [sensor_id](const pb::SensorHere& sensor) {
    return sensor.entry().id() == sensor_id;
  });
}

SharedRoom::Claim SharedRoom::winner(const std::string& sensor) const {
  Claim best;
  const wpb::SensorEntry* here = entry_of(sensor);
  const auto own = claims_.find(sensor);
  if (own != claims_.end() && here != nullptr && here->online() && !is_mirrored(sensor)) {
    best = {own->second.number, context_.own};
  }
  for (const auto& [id, hub] : others_) {
    for (const pb::SensorHere& there : hub.news.sensors()) {
      if (there.entry().name() == sensor) best = std::max(best, Claim{there.claim(), id});
    }
  }
  return best;
}

/// Mirrors exactly those sensors of other hubs that have the highest claim to their name.
void SharedRoom::mirror_winners() {
  std::map<HubId, std::vector<hub::federation::SensorThere>> online;
  for (const auto& [id, hub] : others_) {
    for (const pb::SensorHere& there : hub.news.sensors()) {
      if (winner(there.entry().name()).hub != id) continue;
      online[id].push_back({.entry = there.entry(), .token_id = there.token_id()});
    }
  }
  for (auto& [id, hub] : others_) hub.sensors.set_online(online[id]);
}

// ---- news

pb::RoomNews SharedRoom::news_of_roster() const {
  pb::RoomNews news;
  news.set_hub(context_.own.value);
  news.set_room(context_.room);
  news.set_revision(news_.revision());
  for (const wpb::SensorEntry& entry : roster_.sensors()) {
    const auto claim = claims_.find(entry.name());
    if (!entry.online() || claim == claims_.end() || is_mirrored(entry.name())) continue;
    pb::SensorHere& sensor = *news.add_sensors();
    *sensor.mutable_entry() = entry;
    sensor.set_claim(claim->second.number);
    sensor.set_token_id(claim->second.token_id);
  }
  for (const wpb::SensorEntry& entry : roster_.sensors()) {
    if (!is_owner() || entry.placement() == wpb::PLACEMENT_GIVEN) continue;
    *news.add_placed() = entry;
  }
  *news.mutable_people() = people_here_.people().people();
  return news;
}

void SharedRoom::publish_news() {
  pb::RoomNews news = news_of_roster();
  if (news.SerializeAsString() == news_.SerializeAsString()) return;
  news.set_revision(news.revision() + 1);
  news_ = std::move(news);
  context_.out.broadcast_news(news_);
}

SharedRoom::OtherHub& SharedRoom::other(HubId hub) {
  const auto known = others_.find(hub);
  if (known != others_.end()) return known->second;
  hub::federation::MirroredSensors sensors(hub.value, context_.room, context_.token, context_.rooms,
                                           context_.new_connection);
  return others_.emplace(hub, OtherHub{{}, std::move(sensors), {}}).first->second;
}

std::uint32_t SharedRoom::revision_of(HubId hub) const {
  const auto known = others_.find(hub);
  return known == others_.end() ? 0 : known->second.news.revision();
}

void SharedRoom::on_news(const pb::RoomNews& news) {
  const HubId from{news.hub()};
  if (from == context_.own || news.revision() <= revision_of(from) || !is_legal(news)) return;
  other(from).news = news;
  mirror_winners();
  place_sensors();
  people_there_.set(from, news.people());
  show_people();
}

void SharedRoom::on_frames(HubId from, std::span<const std::uint8_t> message) {
  const auto hub = others_.find(from);
  if (hub == others_.end()) return;
  hub->second.unpacker.take(
      message, [&](net::MessageBuffer frame) { hub->second.sensors.frame(std::move(frame)); });
  hub->second.sensors.deliver_frames();
}

void SharedRoom::set_other_urls(const std::vector<std::string>& urls) {
  if (!is_welcome_ || urls == other_urls_) return;
  other_urls_ = urls;
  wpb::Control control;
  control.mutable_other_hubs()->mutable_urls()->Assign(urls.begin(), urls.end());
  context_.rooms.on_control(*aligner_, control);
}

void SharedRoom::set_clock(HubId hub, const client::ClockEstimate& estimate) {
  other(hub).sensors.set_clock(estimate);
}

void SharedRoom::remove_hub(HubId hub) {
  const auto found = others_.find(hub);
  if (found == others_.end()) return;
  found->second.sensors.on_hub_lost();
  others_.erase(found);
  mirror_winners();
  people_there_.set(hub, {});
  show_people();
}

// ---- people

void SharedRoom::show_people() {
  if (!is_welcome_) return;
  if (const auto news = shown_presence_.update(people_there_.all())) {
    context_.rooms.on_control(*aligner_, *news);
  }
}

void SharedRoom::on_poses(const pb::PeopleMoved& people) {
  const HubId from{people.hub()};
  if (from == context_.own || !is_welcome_) return;
  wpb::Control control;
  *control.mutable_viewer_poses() = people_there_.renamed(from, people.poses());
  if (wire::check_control(control)) context_.rooms.on_control(*aligner_, control);
}

void SharedRoom::broadcast_poses(const wpb::ViewerPoses& poses) {
  if (poses.poses().empty()) return;
  pb::PeopleMoved moved;
  moved.set_hub(context_.own.value);
  *moved.mutable_poses() = poses;
  context_.out.broadcast_poses(context_.room, moved);
}

void SharedRoom::resend_poses() {
  broadcast_poses(people_here_.newest_poses());
}

}  // namespace roomcast::hub::federation
