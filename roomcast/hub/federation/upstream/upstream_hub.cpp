// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/upstream/upstream_hub.h"

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

UpstreamHub::UpstreamHub(UpstreamOptions options, hub::BackplaneContext context)
    : options_(std::move(options)), context_(std::move(context)) {}

void UpstreamHub::watch(const std::string& name, bool is_watched) {
  const auto found = rooms_.find(name);
  if (found == rooms_.end()) {
    if (is_watched) pull(name);
    return;
  }
  Pulled& pulled = *found->second;
  pulled.is_watched = is_watched;
  pulled.end.cancel();
  if (!is_watched) end_later(name, pulled);
}

void UpstreamHub::pull(const std::string& name) {
  auto find_room = [this, name]() -> BackplaneRoom* {
    const auto pulled = rooms_.find(name);
    return pulled == rooms_.end() ? nullptr : &pulled->second->room;
  };
  auto new_connection = [this, find_room = std::move(find_room)] {
    return std::make_shared<BackplaneConnection>(context_.connection_ids.next(), find_room);
  };
  MirroredRoom mirror(name, context_.token, context_.rooms, std::move(new_connection));
  rooms_[name] = std::unique_ptr<Pulled>(
      new Pulled{.room{context_.io, options_, name, std::move(mirror), context_.revoke},
                 .end = net::Timer(context_.io)});
}

void UpstreamHub::end_later(const std::string& name, Pulled& pulled) {
  pulled.end.once(options_.kept_unwatched, [this, name] {
    const auto room = rooms_.find(name);
    if (room != rooms_.end() && !room->second->is_watched) end(room);
  });
}

void UpstreamHub::end(Rooms::iterator room) {
  const auto ended = rooms_.extract(room);
  add_traffic(ended.mapped()->room, ended_);
  ended.mapped()->room.mirror().on_hub_lost();
}

hub::BackplaneStats UpstreamHub::stats() const {
  hub::BackplaneStats stats = ended_;
  for (const auto& [name, pulled] : rooms_) {
    ++stats.links;
    if (pulled->room.is_welcome()) ++stats.links_up;
    add_traffic(pulled->room, stats);
  }
  return stats;
}

}  // namespace roomcast::hub::federation
