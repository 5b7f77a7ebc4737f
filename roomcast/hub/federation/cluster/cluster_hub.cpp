// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/cluster/cluster_hub.h"

#include <algorithm>
#include <random>
#include <utility>

#include "roomcast/hub/federation/cluster/revoked_tokens.h"
#include "roomcast/hub/federation/cluster/subjects.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub::federation {
namespace {

template <class Message>
std::vector<std::uint8_t> bytes_of(const Message& message) {
  std::vector<std::uint8_t> bytes(message.ByteSizeLong());
  message.SerializeToArray(bytes.data(), static_cast<int>(bytes.size()));
  return bytes;
}

}  // namespace

Result<std::unique_ptr<ClusterHub>> ClusterHub::open(ClusterOptions options,
                                                     hub::BackplaneContext context) {
  std::unique_ptr<ClusterHub> hub(new ClusterHub(std::move(options), std::move(context)));
  NatsHandlers handlers{
      .on_message = [hub = hub.get()](auto subject,
                                      auto bytes) { hub->on_message(subject, bytes); },
      .on_connected = [hub = hub.get()] { hub->send_heartbeat(); },
      .log = hub->options_.log};
  auto nats = NatsClient::open(hub->options_.nats, hub->context_.io, std::move(handlers));
  if (!nats) return nats.error();
  hub->nats_ = *std::move(nats);
  hub->nats_->subscribe(kHeartbeatSubject);
  hub->nats_->subscribe(kRevokedSubject);
  hub->nats_->subscribe(inbox_subject(hub->id_));
  hub->schedule_heartbeat();
  return hub;
}

ClusterHub::ClusterHub(ClusterOptions options, hub::BackplaneContext context)
    : options_(std::move(options)), context_(std::move(context)), timer_(context_.io) {}

ClusterHub::~ClusterHub() {
  timer_.stop();
  if (nats_) send_heartbeat(true);
}

// ---- rooms

void ClusterHub::room_opened(const std::string& name) {
  auto find_room = [this, name]() -> BackplaneRoom* {
    const Room* room = find(name);
    return room == nullptr ? nullptr : room->shared.get();
  };
  auto new_connection = [this, find_room = std::move(find_room)] {
    return std::make_shared<BackplaneConnection>(context_.connection_ids.next(), find_room);
  };
  SharedRoom::Context context{.own = id_,
                              .room = name,
                              .token = context_.token,
                              .rooms = context_.rooms,
                              .new_connection = std::move(new_connection),
                              .out = *this};
  rooms_[name] =
      std::unique_ptr<Room>(new Room{.shared = std::make_unique<SharedRoom>(std::move(context)),
                                     .packer = FramePacker(nats_->max_message_bytes()),
                                     .gathered = net::Timer(context_.io),
                                     .unwatched = net::Timer(context_.io)});
  nats_->subscribe(news_subject(name));
  // Deferred: all rooms are opened in sequence before any of them can accept a client.
  boost::asio::post(context_.io, [this, name] {
    if (Room* room = find(name)) room->shared->ensure_joined();
  });
}

void ClusterHub::room_closed(const std::string& name) {
  nats_->unsubscribe(news_subject(name));
  nats_->unsubscribe(all_frames_subject(name));
  nats_->unsubscribe(poses_subject(name));
  rooms_.erase(name);
}

ClusterHub::Room* ClusterHub::find(std::string_view name) {
  const auto room = rooms_.find(name);
  return room == rooms_.end() ? nullptr : room->second.get();
}

void ClusterHub::watch(const std::string& name, bool is_watched) {
  Room* room = find(name);
  if (room == nullptr) return;
  room->is_watched = is_watched;
  room->unwatched.cancel();
  if (is_watched && !std::exchange(room->is_subscribed, true)) {
    nats_->subscribe(all_frames_subject(name));
    nats_->subscribe(poses_subject(name));
    return send_heartbeat();
  }
  if (is_watched) return;
  room->unwatched.once(options_.kept_unwatched, [this, name] {
    Room* unwatched = find(name);
    if (unwatched == nullptr || unwatched->is_watched) return;
    unwatched->is_subscribed = false;
    nats_->unsubscribe(all_frames_subject(name));
    nats_->unsubscribe(poses_subject(name));
    send_heartbeat();
  });
}

/// Takes from the directory whether other hubs want this room's frames.
void ClusterHub::update_wanted(const std::string& name, Room& room) {
  const bool is_wanted = directory_.is_wanted(name);
  if (std::exchange(room.is_wanted, is_wanted) != is_wanted)
    context_.rooms.on_watched_elsewhere(name, is_wanted);
}

void ClusterHub::sensor_joins(const std::string& room, const std::string& name,
                              const std::string& token_id) {
  if (Room* found = find(room)) found->shared->sensor_joins(name, token_id);
}

void ClusterHub::frame(const std::string& name, const wire::FrameHeader&,
                       std::span<const std::uint8_t> message) {
  Room* room = find(name);
  if (room == nullptr || !room->is_wanted) return;
  if (room->packer.byte_count() + message.size() > wire::kMaxFrameBytes) flush(*room);
  room->packer.add(message);
  if (!room->shared->has_sensors_elsewhere()) return;  // set_closed() sends them
  if (room->packer.frame_count() >= room->shared->local_sensor_count()) return flush(*room);
  if (room->packer.frame_count() > 1) return;
  room->gathered.once(kGatherFor, [this, name] {
    if (Room* gathered = find(name)) flush(*gathered);
  });
}

void ClusterHub::set_closed(const std::string& name) {
  Room* room = find(name);
  if (room == nullptr || room->packer.frame_count() == 0) return;
  room->packer.close_set();
  flush(*room);
}

void ClusterHub::flush(Room& room) {
  room.gathered.cancel();
  for (auto& message : room.packer.take()) {
    nats_->publish_now(frames_subject(room.shared->name(), id_), std::move(message));
  }
}

// ---- to other hubs

void ClusterHub::broadcast_news(const pb::RoomNews& news) {
  nats_->publish(news_subject(news.room()), bytes_of(news));
  send_heartbeat();
}

void ClusterHub::send_to(HubId hub, const pb::ToHub& message) {
  nats_->publish(inbox_subject(hub), bytes_of(message));
}

void ClusterHub::broadcast_poses(const std::string& room, const pb::PeopleMoved& people) {
  const Room* moved_in = find(room);
  if (moved_in != nullptr && moved_in->is_wanted) {
    nats_->publish_now(poses_subject(room), bytes_of(people));
  }
}

pb::Heartbeat ClusterHub::heartbeat() const {
  pb::Heartbeat own;
  own.set_hub(id_.value);
  own.set_sent_ns(static_cast<std::uint64_t>(clock_.now().time_since_epoch().count()));
  own.set_public_url(options_.public_url);
  own.set_aligns(options_.on_owned != nullptr);
  own.set_load(load_.cores());
  own.set_cores(options_.cores);
  for (const auto& [name, room] : rooms_) {
    if (room->shared->revision() == 0 && !room->is_subscribed) continue;
    pb::RoomHere& here = *own.add_rooms();
    here.set_room(name);
    here.set_revision(room->shared->revision());
    here.set_sensors(static_cast<std::uint32_t>(room->shared->local_sensor_count()));
    here.set_viewers(static_cast<std::uint32_t>(room->shared->viewer_count()));
    here.set_wants_frames(room->is_subscribed);
  }
  return own;
}

void ClusterHub::send_heartbeat(bool leaves) {
  pb::Heartbeat own = heartbeat();
  own.set_leaves(leaves);
  if (heartbeat_number_ % kHeartbeatsPerList == 0) {
    for (const auto& [name, room] : rooms_) own.add_all_rooms(name);
  }
  directory_.write_heard(own);
  nats_->publish(kHeartbeatSubject, bytes_of(own));
}

/// Intervals are random: heartbeats serve to compare clocks, and heartbeats in step with frames
/// would be delayed by a frame every time.
void ClusterHub::schedule_heartbeat() {
  std::uniform_real_distribution<double> share(0.7, 1.3);
  const auto interval =
      std::chrono::duration_cast<nanoseconds>(kHeartbeatInterval * share(random_));
  timer_.once(interval, [this] {
    run_heartbeat();
    schedule_heartbeat();
  });
}

void ClusterHub::run_heartbeat() {
  load_.sample(clock_.now());
  for (const HubId gone : directory_.remove_gone(clock_.now())) {
    if (options_.log) options_.log(LogLevel::kWarning, "hub " + to_string(gone) + " is gone");
    for (const auto& [name, room] : rooms_) room->shared->remove_hub(gone);
  }
  update_rooms();
  ++heartbeat_number_;
  send_heartbeat();
}

void ClusterHub::update_rooms() {
  auto urls = directory_.urls();
  if (urls != reported_urls_) context_.set_peer_urls(reported_urls_ = std::move(urls));
  const pb::Heartbeat own = heartbeat();
  for (const auto& [name, room] : rooms_) {
    room->asked.clear();
    room->shared->ensure_joined();
    update_wanted(name, *room);
    room->shared->set_other_urls(directory_.urls_with(name));
    const auto owner = owner_of(name, own, directory_);
    const bool was_ours = room->owner == id_;
    room->owner = owner;
    room->shared->set_owner(owner);
    if (was_ours != (owner == id_)) report_owned(name, owner == id_);
    if (heartbeat_number_ % kHeartbeatsPerList == 0) room->shared->resend_poses();
  }
}

void ClusterHub::report_owned(const std::string& room, bool owns) const {
  if (options_.log) {
    options_.log(LogLevel::kInfo, std::string(owns ? "estimates" : "no longer estimates") +
                                      " the poses of the sensors of \"" + room + "\"");
  }
  options_.on_owned(room, owns);
}

void ClusterHub::revoked(const std::vector<hub::Claims>& tokens) {
  nats_->publish(kRevokedSubject, bytes_of(revoked_message(tokens)));
}

}  // namespace roomcast::hub::federation
