// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/room_hall.h"

#include <algorithm>
#include <utility>

#include "roomcast/hub/runtime/control_message.h"
#include "roomcast/hub/runtime/revoked_message.h"

namespace roomcast::hub {

namespace {

namespace pb = wire::pb;

/// What somebody types wrong, or guesses; an old token is an honest mistake.
bool is_fault(pb::ErrorCode code) {
  return code == pb::ERROR_TOKEN_INVALID || code == pb::ERROR_CODE_USED;
}

std::string_view role_of(const pb::Join& join) {
  if (join.has_sensor()) return "sensor";
  if (join.has_aligner()) return "aligner";
  return join.viewer().serves_on() ? "hub" : "viewer";
}

std::string described(const Arrival& arrival, const pb::Join& join) {
  return std::string(role_of(join)) + " \"" + join.name() + "\" from " + arrival.address;
}

}  // namespace

RoomHall::RoomHall(RoomHallOptions options, boost::asio::io_context& io, Desk& desk,
                   const std::vector<std::unique_ptr<Shard>>& shards)
    : options_(std::move(options)),
      io_(io),
      desk_(desk),
      shards_(shards),
      bans_(options_.bans),
      timer_(io) {}

// ---- rooms

void RoomHall::open(const RoomSettings& settings, std::vector<KnownSensor> sensors) {
  Room room(settings, options_.hub_version, options_.recalls_poses);
  room.remember(std::move(sensors));
  HostedRoom::Surroundings around{
      .io = io_,
      .shards = shards_,
      .desk = desk_,
      .backplane = backplane_,
      .clock = clock_,
      .complain = [this](const std::string& line) { log(LogLevel::kWarning, line); },
      .on_let_go = [this](const Disconnect& end) { let_go(end); }};
  rooms_[settings.name] =
      std::make_shared<HostedRoom>(RoomId{next_room_id_++}, std::move(room), std::move(around));
  if (backplane_ != nullptr) backplane_->room_opened(settings.name);
}

void RoomHall::change(const RoomSettings& settings) {
  rooms_.at(settings.name)->room().change(settings);
}

void RoomHall::close(const std::string& name) {
  const auto found = rooms_.find(name);
  if (backplane_ != nullptr) backplane_->room_closed(name);
  for (const ConnectionId guest : found->second->room().connections()) {
    send_away(guest, "this room was closed");
  }
  found->second->close();
  std::erase_if(dropped_sets_,
                [id = found->second->id()](const auto& entry) { return entry.first.first == id; });
  rooms_.erase(found);
}

void RoomHall::forget_sensor(const std::string& room, const std::string& sensor) {
  HostedRoom& hosted = *rooms_.at(room);
  hosted.carry_out(hosted.room().forget(sensor, hosted.now()));
}

const RoomSettings* RoomHall::find(const std::string& room) const {
  const auto found = rooms_.find(room);
  return found == rooms_.end() ? nullptr : &found->second->room().settings();
}

std::string RoomHall::only_listed_room() const {
  std::string only;
  for (const auto& [name, hosted] : rooms_) {
    if (!hosted->room().settings().listed) continue;
    if (!only.empty()) return "";
    only = name;
  }
  return only;
}

// ---- who comes

bool RoomHall::may_connect(const std::string& peer) const {
  return !bans_.is_banned(peer, clock_.now());
}

void RoomHall::on_join(const Arrival& arrival, const pb::Join& join) {
  guests_[arrival.from] = {.address = arrival.address, .name = join.name(), .role = role_of(join)};
  if (!join.code().empty()) {
    return desk_.ask([code = join.code()](HubBook& book) { return book.redeem(code); },
                     [this, arrival, join](const Verdict<NewToken>& redeemed) {
                       on_checked(arrival, join, redeemed, true);
                     });
  }
  if (join.token().empty()) return decide(arrival, join, nullptr, "");
  desk_.ask(
      [token = join.token()](HubBook& book) -> Verdict<NewToken> {
        auto verdict = book.check(token);
        if (const Refusal* why = refusal(verdict)) return *why;
        return NewToken{std::get<Claims>(std::move(verdict)), token};
      },
      [this, arrival, join](const Verdict<NewToken>& checked) {
        on_checked(arrival, join, checked, false);
      });
}

void RoomHall::on_checked(const Arrival& arrival, const pb::Join& join,
                          const Verdict<NewToken>& shown, bool was_code) {
  if (!guests_.contains(arrival.from)) return;  // it did not wait
  if (const Refusal* why = refusal(shown)) return refuse(arrival, join, *why);
  const auto& [claims, token] = std::get<NewToken>(shown);
  decide(arrival, join, &claims, was_code ? token : "");
}

void RoomHall::decide(const Arrival& arrival, const pb::Join& join, const Claims* claims,
                      const std::string& new_token) {
  const auto verdict = decide_entry(
      join, claims, [this](const std::string& name) { return find(name); }, only_listed_room());
  if (const Refusal* why = refusal(verdict))
    return refuse(arrival, join, *why, claims == nullptr ? "" : claims->id);
  Entry entry = std::get<Entry>(verdict);
  if (send_on(arrival, join, entry.room)) return;
  entry.new_token = new_token;
  if (arrival.token_id_there) entry.token_id = *arrival.token_id_there;
  entry.other_hub = arrival.other_hub;
  admit(arrival, join, entry);
}

void RoomHall::refuse(const Arrival& arrival, const pb::Join& join, const Refusal& why,
                      const std::string& token_id) {
  ++refused_joins_;
  guests_.erase(arrival.from);
  log(LogLevel::kInfo, arrival.address + " is refused: " + why.sentence,
      {{"event", "refuse"},
       {"room", join.room()},
       {"role", role_of(join)},
       {"name", join.name()},
       {"peer", arrival.address},
       {"token", token_id},
       {"error", pb::ErrorCode_Name(why.code)}});
  hold_against(arrival.peer, why);
  if (is_of_backplane(arrival.from)) return backplane_->let_go(arrival.from);
  shards_[Shard::of(arrival.from, shards_.size())]->disconnect(arrival.from, why.code,
                                                               why.sentence);
}

void RoomHall::hold_against(const std::string& peer, const Refusal& why) {
  const auto& exempt = options_.never_banned;
  if (!is_fault(why.code) || std::ranges::find(exempt, peer) != exempt.end()) return;
  if (!bans_.fault(peer, clock_.now())) return;
  log(LogLevel::kWarning,
      peer + " shows bad tokens again and again; it is not listened to for a while",
      {{"event", "ban"}, {"peer", peer}});
}

/// To a hub that is less busy, where there is one. Nobody is sent on twice.
bool RoomHall::send_on(const Arrival& arrival, const pb::Join& join, const std::string& room) {
  if (backplane_ == nullptr || !join.has_viewer() || join.sent_on()) return false;
  const auto urls = backplane_->less_busy_hubs(room);
  if (urls.empty()) return false;
  log(LogLevel::kInfo, described(arrival, join) + " is sent on to " + urls.front(),
      {{"event", "send_on"},
       {"room", room},
       {"role", role_of(join)},
       {"name", join.name()},
       {"peer", arrival.address}});
  guests_.erase(arrival.from);
  pb::Control others;
  others.mutable_other_hubs()->mutable_urls()->Assign(urls.begin(), urls.end());
  Shard& shard = *shards_[Shard::of(arrival.from, shards_.size())];
  shard.send_control({arrival.from}, sealed_control(others));
  shard.disconnect(arrival.from, pb::ERROR_BUSY,
                   "this hub is busy; the room is at " + urls.front() + ", too");
  return true;
}

void RoomHall::admit(const Arrival& arrival, const pb::Join& join, const Entry& entry) {
  HostedRoom& room = *rooms_.at(entry.room);
  Guest& guest = guests_[arrival.from];
  guest.room = &room;
  guest.token_id = entry.token_id;
  guest.expires_at = entry.expires_at;
  guest.serves_on = join.viewer().serves_on();
  log_guest(described(arrival, join) + " joins \"" + entry.room + "\"", guest, "join");
  if (backplane_ != nullptr && join.has_sensor() && !is_of_backplane(arrival.from)) {
    backplane_->sensor_joins(entry.room, join.name(), entry.token_id);
  }
  room.carry_out(room.room().join(arrival.from, join, entry, room.now()));
  if (join.viewer().serves_on()) greet_hub(arrival.from);
  if (join.has_sensor() && options_.on_in_use && in_use_.insert(room.id()).second) {
    options_.on_in_use(entry.room);
  }
}

/// It learns which tokens hold no more before it was here.
void RoomHall::greet_hub(ConnectionId hub) {
  desk_.ask([](HubBook& book) { return book.revoked(); },
            [this, hub](const Result<std::vector<Claims>>& revoked) {
              if (revoked && room_of(hub) != nullptr) tell_hub_behind(hub, *revoked);
            });
}

// ---- what they say

HostedRoom* RoomHall::room_of(ConnectionId from) const {
  const auto guest = guests_.find(from);
  return guest == guests_.end() ? nullptr : guest->second.room;
}

void RoomHall::on_control(ConnectionId from, const pb::Control& message) {
  if (HostedRoom* room = room_of(from)) {
    room->carry_out(room->room().control(from, message, room->now()));
  }
}

void RoomHall::on_frame(ConnectionId from, const wire::FrameHeader& header,
                        net::MessageBuffer message) {
  HostedRoom* room = room_of(from);
  if (room == nullptr) return;
  if (backplane_ != nullptr && !is_of_backplane(from) &&
      !room->room().fault_of(from, header, room->now())) {
    backplane_->frame(room->room().name(), header, message.payload());
  }
  room->carry_out(room->room().frame(from, header, std::move(message), room->now()));
}

void RoomHall::on_frames(std::span<IncomingFrame> together) {
  HostedRoom* room = room_of(together.front().from);
  if (room != nullptr) room->carry_out(room->room().frames(together, room->now()));
}

void RoomHall::on_key_needs(ConnectionId from, const std::vector<SensorId>& sensors) {
  HostedRoom* room = room_of(from);
  if (room == nullptr) return;
  for (const SensorId sensor : sensors) {
    room->carry_out(room->room().key_needed(sensor, room->now()));
  }
}

void RoomHall::on_left(ConnectionId from, const net::CloseReason& reason) {
  const auto guest = guests_.find(from);
  if (guest == guests_.end()) return;  // we sent it away
  log_guest(guest->second.address + " has left: " + reason.sentence, guest->second, "leave");
  HostedRoom* room = guest->second.room;
  guests_.erase(guest);
  if (room != nullptr) room->carry_out(room->room().leave(from, room->now()));
}

void RoomHall::log_guest(const std::string& line, const Guest& guest, std::string_view event,
                         std::string_view error) const {
  log(LogLevel::kInfo, line,
      {{"event", event},
       {"room", guest.room == nullptr ? std::string_view() : guest.room->room().name()},
       {"role", guest.role},
       {"name", guest.name},
       {"peer", guest.address},
       {"token", guest.token_id},
       {"error", error}});
}

// ---- sending away

/// The room's doing, or ours.
void RoomHall::let_go(const Disconnect& end) {
  const auto guest = guests_.find(end.connection);
  if (guest == guests_.end()) return;
  log_guest(guest->second.address + " is sent away: " + end.sentence, guest->second, "send_away",
            pb::ErrorCode_Name(end.code));
  guests_.erase(guest);
}

bool RoomHall::send_away(ConnectionId guest, const std::string& sentence) {
  HostedRoom* room = room_of(guest);
  if (room != nullptr) room->send_away(guest, pb::ERROR_NOT_ALLOWED, sentence);
  return room != nullptr;
}

void RoomHall::tell_revoked() {
  desk_.ask([](HubBook& book) { return book.revoked(); },
            [this](const Result<std::vector<Claims>>& revoked) {
              if (!revoked || revoked->empty()) return;
              if (backplane_ != nullptr) backplane_->revoked(*revoked);
              tell_hubs_behind(*revoked);
            });
}

void RoomHall::tell_hubs_behind(const std::vector<Claims>& revoked) {
  for (const auto& [connection, guest] : guests_) {
    if (guest.room != nullptr && guest.serves_on) tell_hub_behind(connection, revoked);
  }
}

void RoomHall::tell_hub_behind(ConnectionId hub, const std::vector<Claims>& revoked) {
  for (const pb::Control& message : revoked_messages(revoked, room_of(hub)->room().name())) {
    shards_[Shard::of(hub, shards_.size())]->send_control({hub}, sealed_control(message));
  }
}

void RoomHall::take_revoked(std::vector<Claims> tokens) {
  std::vector<std::string> ids;
  for (const Claims& token : tokens) ids.push_back(token.id);
  desk_.ask([tokens = std::move(tokens)](HubBook& book) { return book.take_revoked(tokens); },
            [this, ids = std::move(ids)](const Result<std::vector<Claims>>& news) {
              if (!news) log(LogLevel::kWarning, news.error().message);
              send_away_holders(ids);
              if (news) tell_hubs_behind(*news);
            });
}

void RoomHall::send_away_holders(const std::vector<std::string>& token_ids) {
  std::vector<std::pair<ConnectionId, HostedRoom*>> holders;
  for (const auto& [connection, guest] : guests_) {
    const bool holds = guest.room != nullptr && !guest.token_id.empty() &&
                       std::ranges::find(token_ids, guest.token_id) != token_ids.end();
    if (holds) holders.emplace_back(connection, guest.room);
  }
  for (const auto& [connection, room] : holders) {
    room->send_away(connection, pb::ERROR_TOKEN_REVOKED, "this token was revoked");
  }
}

}  // namespace roomcast::hub
