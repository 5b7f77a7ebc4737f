// SPDX-License-Identifier: Apache-2.0
// Messages that a ClusterHub receives from other hubs, and its view of these hubs.
#include <utility>

#include "roomcast/hub/federation/cluster/cluster_hub.h"
#include "roomcast/hub/federation/cluster/revoked_tokens.h"
#include "roomcast/hub/federation/cluster/subjects.h"
#include "roomcast/wire/parse_message.h"

namespace roomcast::hub::federation {
namespace {

template <class Message>
std::optional<Message> read(std::span<const std::uint8_t> bytes) {
  Message message;
  if (!wire::parse_message(bytes, message)) return std::nullopt;
  return message;
}

}  // namespace

void ClusterHub::on_message(std::string_view subject, std::span<const std::uint8_t> bytes) {
  const auto what = read_subject(subject);
  if (!what) return;
  if (what->subject == Subject::kHeartbeat) {
    if (const auto heartbeat = read<pb::Heartbeat>(bytes)) on_heartbeat(*heartbeat);
  } else if (what->subject == Subject::kInbox) {
    const auto message = read<pb::ToHub>(bytes);
    Room* room = message ? find(message->room()) : nullptr;
    if (room != nullptr && directory_.find(HubId{message->from()}))
      room->shared->on_message(*message);
  } else if (what->subject == Subject::kNews) {
    const auto news = read<pb::RoomNews>(bytes);
    Room* room = find(what->room);
    if (room != nullptr && news && directory_.find(HubId{news->hub()}))
      room->shared->on_news(*news);
  } else if (what->subject == Subject::kRevoked) {
    if (const auto revoked = read<pb::Revoked>(bytes)) on_revoked(*revoked);
  } else if (what->subject == Subject::kPoses) {
    const auto people = read<pb::PeopleMoved>(bytes);
    Room* room = find(what->room);
    if (room != nullptr && people) room->shared->on_poses(*people);
  } else if (what->subject == Subject::kFrames) {
    if (Room* room = find(what->room)) room->shared->on_frames(what->hub, bytes);
  }
}

void ClusterHub::on_heartbeat(const pb::Heartbeat& heartbeat) {
  const HubId from{heartbeat.hub()};
  const bool is_new = directory_.find(from) == nullptr;
  if (!directory_.update(heartbeat, clock_.now())) return;
  const auto estimate = directory_.find(from)->clock.estimate();
  for (const auto& [name, room] : rooms_) {
    const pb::RoomHere* there = room_of(heartbeat, name);
    if (there == nullptr) continue;
    update_wanted(name, *room);
    if (estimate) room->shared->set_clock(from, *estimate);
    if (there->revision() > room->shared->revision_of(from) && room->asked.insert(from).second) {
      pb::ToHub please;
      please.set_from(id_.value);
      please.set_room(name);
      please.mutable_news_please();
      send_to(from, please);
    }
  }
  if (heartbeat.leaves()) run_heartbeat();
  if (!is_new) return;
  heartbeat_number_ = 0;
  send_heartbeat();  // so that the new hub knows of this one at once
  context_.send_revoked();
}

void ClusterHub::on_revoked(const pb::Revoked& revoked) {
  auto tokens = revoked_tokens(revoked);
  if (!tokens.empty()) context_.revoke(std::move(tokens));
}

// ---- state of the hubs

std::vector<std::string> ClusterHub::less_busy_hubs(const std::string& room) const {
  const pb::Heartbeat own = heartbeat();
  const bool is_busy = options_.busy_share > 0 && busy_share(own) > options_.busy_share;
  return is_busy ? directory_.less_busy_with(room, own) : std::vector<std::string>();
}

hub::BackplaneStats ClusterHub::stats() const {
  const NatsStats nats = nats_->stats();
  return {.links = 1,
          .links_up = nats.is_connected ? 1U : 0U,
          .other_hubs = directory_.others().size(),
          .sent = nats.sent,
          .received = nats.received,
          .dropped = nats.dropped};
}

std::vector<hub::HubStatus> ClusterHub::hubs() const {
  std::vector<hub::HubStatus> all;
  const auto add = [&all](const pb::Heartbeat& heartbeat) {
    hub::HubStatus& status = all.emplace_back();
    status.id = to_string(HubId{heartbeat.hub()});
    status.public_url = heartbeat.public_url();
    status.load = heartbeat.load();
    for (const pb::RoomHere& room : heartbeat.rooms()) {
      status.rooms.push_back({room.room(), room.sensors(), room.viewers()});
    }
  };
  add(heartbeat());
  for (const auto& [id, hub] : directory_.others()) add(hub.newest);
  return all;
}

}  // namespace roomcast::hub::federation
