// SPDX-License-Identifier: Apache-2.0
// A Room tells its sensors which frames it wants (all, those of layer 0, or none), and at which
// rate.
#include <algorithm>
#include <utility>
#include <vector>

#include <google/protobuf/util/message_differencer.h>

#include "roomcast/hub/room/room.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

constexpr double kImportanceOfBase = 0.3;  // to a viewer who gets layer 0 only

bool is_same(const pb::FrameDemand& a, const pb::FrameDemand& b) {
  return google::protobuf::util::MessageDifferencer::Equals(a, b);
}

/// Of sensors of this hub.
bool is_told(const RoomSensor& sensor) {
  return sensor.connection && !sensor.is_at_other_hub;
}

}  // namespace

RoomActions Room::watch_elsewhere(bool is_watched, RoomTime now) {
  is_watched_elsewhere_ = is_watched;
  RoomActions out;
  update_demand(now, out);
  return out;
}

bool Room::is_watched() const {
  return wants_all() || !viewers_.empty();
}

/// True if the sensors send all frames wherever the viewers look, because a recorder, a relay or an
/// earlier version of a viewer gets them all.
bool Room::wants_all() const {
  return settings_.stream_unwatched || is_watched_elsewhere_ ||
         culling_.viewer_count() < viewers_.size();
}

void Room::look_at_wishes(RoomSensor& sensor) const {
  pb::FrameDemand& wanted = sensor.wanted;
  wanted.Clear();
  wanted.set_wanted(demand_.wanted());
  wanted.set_small(demand_.wanted() && is_wanted_small(sensor.id));
  if (!demand_.wanted() || wants_all()) return;
  const auto wishes = culling_.wishes_for(sensor.id);
  wanted.set_unseen(!viewers_.empty() && wishes.all + wishes.base_only == 0);
  wanted.set_base_only(wishes.all == 0 && wishes.base_only > 0);
}

void Room::share_uplink(RoomTime now) {
  std::vector<UplinkUser> users;
  for (const RoomSensor& sensor : sensors_.all()) {
    if (!is_told(sensor)) continue;
    const auto wishes = culling_.wishes_for(sensor.id);
    const auto all = static_cast<double>(viewers_.size() - culling_.viewer_count() + wishes.all);
    const auto base_only = static_cast<double>(wishes.base_only);
    const pb::SensorRole& role = sensor.description;
    UplinkUser& user = users.emplace_back(UplinkUser{.sensor = sensor.id});
    user.importance = (all + kImportanceOfBase * base_only) /
                      static_cast<double>(std::max<std::size_t>(1, viewers_.size()));
    user.is_paused = !sensor.wanted.wanted() || sensor.wanted.unseen();
    user.follows = role.follows_rate();
    user.most_mbit = role.settings().mbit();
    user.sent_bytes = sensor.stats.bytes;
  }
  uplink_.update(settings_.uplink_mbit, users, now);
  for (RoomSensor& sensor : sensors_.all()) {
    if (is_told(sensor) && sensor.description.follows_rate())
      sensor.wanted.set_mbit(uplink_.of(sensor.id));
  }
}

void Room::update_demand(RoomTime now, RoomActions& out) {
  demand_.update(is_watched(), now);
  tell_demands(now, out);
  views_.expect_change(now);
  tell_views(now, out);
}

void Room::tell_demands_when_due(RoomTime now, RoomActions& out) {
  const bool has_changed = demand_.update(is_watched(), now);
  const bool is_due = uplink_.next() && now >= *uplink_.next();
  if (has_changed || is_due) tell_demands(now, out);
}

/// Tells the sensors of this hub when what is wanted of them has changed.
void Room::tell_demands(RoomTime now, RoomActions& out) {
  for (RoomSensor& sensor : sensors_.all()) look_at_wishes(sensor);
  share_uplink(now);
  std::vector<SendControl> news;
  for (RoomSensor& sensor : sensors_.all()) {
    if (!is_told(sensor) || is_same(sensor.told, sensor.wanted)) continue;
    sensor.told = sensor.wanted;
    sets_.pause_sensor(sensor.id, sensor.told.unseen());
    const auto alike = std::ranges::find_if(news, [&](const SendControl& send) {
      return is_same(send.message.frame_demand(), sensor.told);
    });
    if (alike != news.end()) {
      alike->to.push_back(*sensor.connection);
      continue;
    }
    pb::Control message;
    *message.mutable_frame_demand() = sensor.told;
    news.push_back({{*sensor.connection}, std::move(message)});
  }
  std::ranges::move(news, std::back_inserter(out));
}

/// Tells the sensors of this hub from where they are looked at.
void Room::tell_views(RoomTime now, RoomActions& out) {
  std::vector<ViewTaker> takers;
  for (const RoomSensor& sensor : sensors_.all()) {
    const bool is_placed = sensor.pose.is_placed() && !sensor.pose.is_moved();
    if (is_told(sensor) && is_placed && sensor.description.takes_views())
      takers.push_back({sensor.id, sensor.pose.world_from_depth});
  }
  const auto cones = wants_all() ? std::vector<ViewCone>() : culling_.cones(now);
  for (auto& [id, watched] : views_.update(cones, takers, now)) {
    const RoomSensor* const sensor = sensors_.find(id);
    if (sensor == nullptr || !is_told(*sensor)) continue;
    pb::Control message;
    *message.mutable_watched_from() = std::move(watched);
    out.push_back(SendControl{{*sensor->connection}, std::move(message)});
  }
}

}  // namespace roomcast::hub
