// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/room_registry.h"

#include <algorithm>
#include <utility>

#include "roomcast/hub/runtime/revoked_message.h"

namespace roomcast::hub {

namespace {

namespace pb = wire::pb;

/// Whether a refusal counts towards a ban: it may come from guessing. An expired or revoked token
/// does not count.
bool is_fault(pb::ErrorCode code) {
  return code == pb::ERROR_TOKEN_INVALID || code == pb::ERROR_CODE_USED;
}

std::string_view role_of(const pb::Join& join) {
  if (join.has_sensor()) return "sensor";
  if (join.has_aligner()) return "aligner";
  if (join.has_modeler()) return "modeler";
  return join.viewer().relays() ? "hub" : "viewer";
}

std::string described(const ConnectionInfo& connection_info, const pb::Join& join) {
  return std::string(role_of(join)) + " \"" + join.name() + "\" from " + connection_info.address;
}

}  // namespace

RoomRegistry::RoomRegistry(RoomRegistryOptions options, boost::asio::io_context& io,
                           StoreWorker& store_worker,
                           const std::vector<std::unique_ptr<Shard>>& shards)
    : options_(std::move(options)),
      io_(io),
      store_worker_(store_worker),
      shards_(shards),
      bans_(options_.bans),
      timer_(io) {}

// ---- rooms

void RoomRegistry::open(const RoomSettings& settings, KnownRoom known) {
  Room room(settings, options_.hub_version, options_.restores_poses);
  room.remember(std::move(known));
  RoomRunner::Context context{
      .io = io_,
      .shards = shards_,
      .store_worker = store_worker_,
      .backplane = backplane_,
      .clock = clock_,
      .warn = [this](const std::string& line) { log(LogLevel::kWarning, line); },
      .on_removed = [this](const Disconnect& end) { on_removed(end); },
      .on_placed = [this](const std::string& name, const auto& s) { note_places(name, s); }};
  rooms_[settings.name] =
      std::make_shared<RoomRunner>(RoomId{next_room_id_++}, std::move(room), std::move(context));
  embed_sites_.set(settings.name, settings.embed_from);
  if (backplane_ != nullptr) backplane_->room_opened(settings.name);
}

void RoomRegistry::change(const RoomSettings& settings) {
  rooms_.at(settings.name)->change(settings);
  embed_sites_.set(settings.name, settings.embed_from);
}

void RoomRegistry::close(const std::string& name) {
  const auto found = rooms_.find(name);
  if (backplane_ != nullptr) backplane_->room_closed(name);
  found->second->close("this room was closed");
  std::erase_if(dropped_sets_,
                [id = found->second->id()](const auto& entry) { return entry.first.first == id; });
  embed_sites_.set(name, {});
  events_.erase(name);
  placed_.erase(name);
  rooms_.erase(found);
}

void RoomRegistry::forget_sensor(const std::string& room, const std::string& sensor) {
  rooms_.at(room)->forget_sensor(sensor);
}

void RoomRegistry::mute(const std::string& room, ViewerId viewer, bool muted) {
  rooms_.at(room)->mute(viewer, muted);
}

const RoomSettings* RoomRegistry::find(const std::string& room) const {
  const auto found = rooms_.find(room);
  return found == rooms_.end() ? nullptr : &found->second->settings();
}

std::string RoomRegistry::only_listed_room() const {
  std::string only;
  for (const auto& [name, room] : rooms_) {
    if (!room->settings().listed) continue;
    if (!only.empty()) return "";
    only = name;
  }
  return only;
}

// ---- joining

bool RoomRegistry::may_connect(const std::string& peer) const {
  return !bans_.is_banned(peer, clock_.now());
}

void RoomRegistry::on_join(const ConnectionInfo& connection_info, const pb::Join& join) {
  clients_[connection_info.id()] = {
      .address = connection_info.address, .name = join.name(), .role = role_of(join)};
  if (!join.code().empty()) {
    return store_worker_.ask([code = join.code()](HubStore& store) { return store.redeem(code); },
                             [this, connection_info, join](const Verdict<NewToken>& redeemed) {
                               on_checked(connection_info, join, redeemed, true);
                             });
  }
  if (join.token().empty()) return decide(connection_info, join, nullptr, "");
  store_worker_.ask(
      [token = join.token()](HubStore& store) -> Verdict<NewToken> {
        auto verdict = store.check(token);
        if (const Refusal* why = refusal(verdict)) return *why;
        return NewToken{std::get<Claims>(std::move(verdict)), token};
      },
      [this, connection_info, join](const Verdict<NewToken>& checked) {
        on_checked(connection_info, join, checked, false);
      });
}

void RoomRegistry::on_checked(const ConnectionInfo& connection_info, const pb::Join& join,
                              const Verdict<NewToken>& shown, bool was_code) {
  if (!clients_.contains(connection_info.id())) return;  // it has disconnected meanwhile
  if (const Refusal* why = refusal(shown)) return refuse(connection_info, join, *why);
  const auto& [claims, token] = std::get<NewToken>(shown);
  decide(connection_info, join, &claims, was_code ? token : "");
}

void RoomRegistry::decide(const ConnectionInfo& connection_info, const pb::Join& join,
                          const Claims* claims, const std::string& new_token) {
  const auto verdict = decide_entry(
      join, claims, [this](const std::string& name) { return find(name); }, only_listed_room());
  if (const Refusal* why = refusal(verdict))
    return refuse(connection_info, join, *why, claims == nullptr ? "" : claims->id);
  Entry entry = std::get<Entry>(verdict);
  if (redirect(connection_info, join, entry.room)) return;
  entry.new_token = new_token;
  if (connection_info.token_id_there) entry.token_id = *connection_info.token_id_there;
  entry.other_hub = connection_info.other_hub;
  entry.is_backplane = connection_info.is_backplane;
  admit(connection_info, join, entry);
}

void RoomRegistry::refuse(const ConnectionInfo& connection_info, const pb::Join& join,
                          const Refusal& why, const std::string& token_id) {
  ++refused_joins_;
  clients_.erase(connection_info.id());
  log(LogLevel::kInfo, connection_info.address + " is refused: " + why.sentence,
      {{"event", "refuse"},
       {"room", join.room()},
       {"role", role_of(join)},
       {"name", join.name()},
       {"peer", connection_info.address},
       {"token", token_id},
       {"error", pb::ErrorCode_Name(why.code)}});
  note(join.room().empty() ? only_listed_room() : join.room(), {.kind = "refused",
                                                                .role = std::string(role_of(join)),
                                                                .name = join.name(),
                                                                .peer = connection_info.address,
                                                                .token_id = token_id,
                                                                .sentence = why.sentence});
  count_fault(connection_info.peer, why);
  connection_info.connection->disconnect(why.code, why.sentence);
}

void RoomRegistry::count_fault(const std::string& peer, const Refusal& why) {
  const auto& exempt = options_.never_banned;
  if (!is_fault(why.code) || std::ranges::find(exempt, peer) != exempt.end()) return;
  if (!bans_.fault(peer, clock_.now())) return;
  log(LogLevel::kWarning, peer + " is banned for a while: too many bad tokens",
      {{"event", "ban"}, {"peer", peer}});
}

/// Redirects a viewer to a less busy hub, if there is one. A viewer is redirected only once. True:
/// redirected.
bool RoomRegistry::redirect(const ConnectionInfo& connection_info, const pb::Join& join,
                            const std::string& room) {
  if (backplane_ == nullptr || !join.has_viewer() || join.redirected()) return false;
  if (!join.viewer().plays().empty()) return false;  // the recording is at this hub
  const auto urls = backplane_->less_busy_hubs(room);
  if (urls.empty()) return false;
  log(LogLevel::kInfo, described(connection_info, join) + " is redirected to " + urls.front(),
      {{"event", "send_on"},
       {"room", room},
       {"role", role_of(join)},
       {"name", join.name()},
       {"peer", connection_info.address}});
  clients_.erase(connection_info.id());
  pb::Control others;
  others.mutable_other_hubs()->mutable_urls()->Assign(urls.begin(), urls.end());
  connection_info.connection->send(others);
  connection_info.connection->disconnect(
      pb::ERROR_BUSY, "this hub is busy; the room is at " + urls.front() + ", too");
  return true;
}

void RoomRegistry::admit(const ConnectionInfo& connection_info, const pb::Join& join,
                         const Entry& entry) {
  RoomRunner& room = *rooms_.at(entry.room);
  Client& client = clients_[connection_info.id()];
  client.room = &room;
  client.token_id = entry.token_id;
  client.expires_at = entry.expires_at;
  client.relays = join.viewer().relays();
  log_client(described(connection_info, join) + " joins \"" + entry.room + "\"", client, "join");
  note_client(client, "joined", "");
  room.join(connection_info.connection, join, entry);
  if (join.viewer().relays()) send_revoked_to_new_hub(connection_info.id());
  if (join.has_sensor() && options_.on_in_use && in_use_.insert(room.id()).second) {
    options_.on_in_use(entry.room);
  }
}

/// Sends a hub that has just joined the tokens revoked so far.
void RoomRegistry::send_revoked_to_new_hub(ConnectionId hub) {
  store_worker_.ask([](HubStore& store) { return store.revoked(); },
                    [this, hub](const Result<std::vector<Claims>>& revoked) {
                      if (revoked && room_of(hub) != nullptr) send_revoked_to_hub(hub, *revoked);
                    });
}

// ---- events of clients

RoomRunner* RoomRegistry::room_of(ConnectionId from) const {
  const auto client = clients_.find(from);
  return client == clients_.end() ? nullptr : client->second.room;
}

void RoomRegistry::on_control(ConnectionId from, const pb::Control& message) {
  if (message.has_settings_answer()) return requests_.answer(from, message.settings_answer());
  note_message(from, message);
  if (RoomRunner* room = room_of(from)) room->control(from, message);
}

void RoomRegistry::on_frame(ConnectionId from, const wire::FrameHeader& header,
                            net::MessageBuffer message) {
  if (RoomRunner* room = room_of(from)) room->frame(from, header, std::move(message));
}

void RoomRegistry::on_audio(ConnectionId from, const wire::AudioHeader& header,
                            net::MessageBuffer message) {
  if (RoomRunner* room = room_of(from)) room->audio(from, header, std::move(message));
}

void RoomRegistry::on_watched_elsewhere(const std::string& room, bool is_watched) {
  const auto found = rooms_.find(room);
  if (found != rooms_.end()) found->second->watch_elsewhere(is_watched);
}

void RoomRegistry::on_frames(std::span<IncomingFrame> together) {
  if (RoomRunner* room = room_of(together.front().from)) room->frames(together);
}

void RoomRegistry::on_key_needs(ConnectionId from, const std::vector<SensorId>& sensors) {
  if (RoomRunner* room = room_of(from)) room->request_keys(sensors);
}

void RoomRegistry::on_small_needs(ConnectionId from, const SmallNeeds& needs) {
  if (RoomRunner* room = room_of(from)) room->need_small(from, needs);
}

void RoomRegistry::on_left(ConnectionId from, const net::CloseReason& reason) {
  const auto client = clients_.find(from);
  if (client == clients_.end()) return;  // the hub has disconnected it
  log_client(client->second.address + " has left: " + reason.sentence, client->second, "leave");
  note_client(client->second, "left", reason.sentence);
  RoomRunner* room = client->second.room;
  clients_.erase(client);
  requests_.sensor_left(from);
  if (room != nullptr) room->leave(from);
}

void RoomRegistry::log_client(const std::string& line, const Client& client, std::string_view event,
                              std::string_view error) const {
  log(LogLevel::kInfo, line,
      {{"event", event},
       {"room", client.room == nullptr ? std::string_view() : client.room->name()},
       {"role", client.role},
       {"name", client.name},
       {"peer", client.address},
       {"token", client.token_id},
       {"error", error}});
}

// ---- disconnecting

/// A room removed the client, by itself or through disconnect_client().
void RoomRegistry::on_removed(const Disconnect& end) {
  const auto client = clients_.find(end.connection);
  if (client == clients_.end()) return;
  log_client(client->second.address + " is disconnected: " + end.sentence, client->second,
             "send_away", pb::ErrorCode_Name(end.code));
  note_client(client->second, "sent_away", end.sentence);
  clients_.erase(client);
  requests_.sensor_left(end.connection);
}

bool RoomRegistry::disconnect_client(ConnectionId client, const std::string& sentence) {
  RoomRunner* room = room_of(client);
  if (room != nullptr) room->disconnect_client(client, pb::ERROR_NOT_ALLOWED, sentence);
  return room != nullptr;
}

void RoomRegistry::send_revoked() {
  store_worker_.ask([](HubStore& store) { return store.revoked(); },
                    [this](const Result<std::vector<Claims>>& revoked) {
                      if (!revoked || revoked->empty()) return;
                      if (backplane_ != nullptr) backplane_->revoked(*revoked);
                      send_revoked_to_downstream(*revoked);
                    });
}

void RoomRegistry::send_revoked_to_downstream(const std::vector<Claims>& revoked) {
  for (const auto& [connection, client] : clients_) {
    if (client.room != nullptr && client.relays) send_revoked_to_hub(connection, revoked);
  }
}

void RoomRegistry::send_revoked_to_hub(ConnectionId hub, const std::vector<Claims>& revoked) {
  const RoomRunner& room = *room_of(hub);
  for (const pb::Control& message : revoked_messages(revoked, room.name())) room.send(hub, message);
}

void RoomRegistry::add_revoked(std::vector<Claims> tokens) {
  std::vector<std::string> ids;
  for (const Claims& token : tokens) ids.push_back(token.id);
  store_worker_.ask(
      [tokens = std::move(tokens)](HubStore& store) { return store.add_revoked(tokens); },
      [this, ids = std::move(ids)](const Result<std::vector<Claims>>& added) {
        if (!added) log(LogLevel::kWarning, added.error().message);
        disconnect_token_holders(ids);
        if (added) send_revoked_to_downstream(*added);
      });
}

void RoomRegistry::disconnect_token_holders(const std::vector<std::string>& token_ids) {
  std::vector<std::pair<ConnectionId, RoomRunner*>> holders;
  for (const auto& [connection, client] : clients_) {
    const bool holds = client.room != nullptr && !client.token_id.empty() &&
                       std::ranges::find(token_ids, client.token_id) != token_ids.end();
    if (holds) holders.emplace_back(connection, client.room);
  }
  for (const auto& [connection, room] : holders) {
    room->disconnect_client(connection, pb::ERROR_TOKEN_REVOKED, "this token was revoked");
  }
}

}  // namespace roomcast::hub
