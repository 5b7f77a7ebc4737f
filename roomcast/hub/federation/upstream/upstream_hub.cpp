// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/upstream/upstream_hub.h"

#include <algorithm>
#include <utility>

namespace roomcast::hub::federation {

namespace {

void add(const hub::BackplaneTraffic& more, hub::BackplaneTraffic& traffic) {
  traffic.messages += more.messages;
  traffic.bytes += more.bytes;
}

void add_traffic(const UpstreamRoom& room, hub::BackplaneStats& stats) {
  add(room.sent(), stats.sent);
  add(room.received(), stats.received);
}

}  // namespace

UpstreamHub::UpstreamHub(UpstreamOptions options, hub::BackplaneContext seat)
    : options_(std::move(options)), context_(std::move(seat)) {}

void UpstreamHub::watch(const std::string& name, bool is_watched) {
  const auto found =
      std::ranges::find_if(rooms_, [&name](const auto& room) { return room.second->name == name; });
  if (found == rooms_.end()) {
    if (is_watched) pull(name);
    return;
  }
  Pulled& pulled = *found->second;
  pulled.is_watched = is_watched;
  pulled.end.cancel();
  if (!is_watched) end_later(found->first, pulled);
}

void UpstreamHub::pull(const std::string& name) {
  const Number number = ++newest_;
  auto new_connection = [number, count = std::make_shared<std::uint32_t>(0)] {
    return hub::backplane_connection(number, ++*count);
  };
  MirroredRoom mirror(name, context_.token, context_.rooms, std::move(new_connection));
  rooms_[number] = std::unique_ptr<Pulled>(
      new Pulled{.name = name,
                 .room{context_.io, options_, name, std::move(mirror), context_.revoke},
                 .end = boost::asio::steady_timer(context_.io)});
}

void UpstreamHub::end_later(Number number, Pulled& pulled) {
  pulled.end.expires_after(options_.kept_unwatched);
  pulled.end.async_wait([this, number](boost::system::error_code error) {
    const auto room = rooms_.find(number);
    if (!error && room != rooms_.end() && !room->second->is_watched) end(room);
  });
}

void UpstreamHub::end(Rooms::iterator room) {
  const auto ended = rooms_.extract(room);
  add_traffic(ended.mapped()->room, ended_);
  ended.mapped()->room.mirror().other_hub_is_gone();
}

UpstreamRoom* UpstreamHub::owner_of(ConnectionId connection) const {
  const auto pulled = rooms_.find(hub::backplane_owner(connection));
  return pulled == rooms_.end() ? nullptr : &pulled->second->room;
}

void UpstreamHub::send(ConnectionId to, const wire::pb::Control& message) {
  if (UpstreamRoom* room = owner_of(to)) room->said(to, message);
}

void UpstreamHub::let_go(ConnectionId connection) {
  if (UpstreamRoom* room = owner_of(connection)) room->mirror().let_go(connection);
}

hub::BackplaneStats UpstreamHub::stats() const {
  hub::BackplaneStats stats = ended_;
  for (const auto& [number, pulled] : rooms_) {
    ++stats.links;
    if (pulled->room.is_welcome()) ++stats.links_up;
    add_traffic(pulled->room, stats);
  }
  return stats;
}

}  // namespace roomcast::hub::federation
