// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/room_events.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace roomcast::hub {

namespace {

constexpr std::string_view kRefused = "refused";

/// At most kMaxSentence bytes, without a character that is cut in two.
void shorten(std::string& text) {
  if (text.size() <= RoomEvents::kMaxSentence) return;
  std::size_t end = RoomEvents::kMaxSentence;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  text.resize(end);
}

/// "192.0.2.7:50312" -> "192.0.2.7": each attempt has a port of its own.
std::string_view host_of(std::string_view peer) {
  return peer.substr(0, peer.rfind(':'));
}

}  // namespace

void RoomEvents::add(RoomEvent event, UnixSeconds at) {
  shorten(event.sentence);
  if (event.kind == kRefused && merge(event, at)) return;
  event.id = event.number = ++newest_;
  event.at = at;
  if (event.kind == kRefused) ++refusals_;
  events_.push_back(std::move(event));
  forget_the_oldest();
}

bool RoomEvents::merge(const RoomEvent& event, UnixSeconds at) {
  const auto same = std::ranges::find_if(events_, [&](const RoomEvent& known) {
    return known.kind == kRefused && known.role == event.role && known.name == event.name &&
           known.sentence == event.sentence && host_of(known.peer) == host_of(event.peer);
  });
  if (same == events_.end()) return false;
  RoomEvent merged = std::move(*same);
  events_.erase(same);
  merged.peer = event.peer;
  merged.at = at;
  merged.number = ++newest_;
  ++merged.times;
  events_.push_back(std::move(merged));
  return true;
}

void RoomEvents::forget_the_oldest() {
  if (refusals_ > kMaxRefusals) {
    events_.erase(std::ranges::find(events_, kRefused, &RoomEvent::kind));
    --refusals_;
  }
  if (events_.size() <= kMaxEvents) return;
  if (events_.front().kind == kRefused) --refusals_;
  events_.pop_front();
}

RoomEvents::Page RoomEvents::after(std::uint64_t after) const {
  Page page{.newest = newest_};
  for (auto event = std::ranges::upper_bound(events_, after, {}, &RoomEvent::number);
       event != events_.end() && page.events.size() < kMaxPage; ++event) {
    page.events.push_back(*event);
  }
  return page;
}

}  // namespace roomcast::hub
