// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/voice_relay.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {

namespace {

/// Infinite if one of them has no head.
float distance_m(const std::optional<Eigen::Vector3f>& a, const std::optional<Eigen::Vector3f>& b) {
  return a && b ? (*a - *b).norm() : std::numeric_limits<float>::infinity();
}

}  // namespace

void VoiceRelay::add_listener(ViewerId viewer, ConnectionId connection, Hearing hearing) {
  listeners_.push_back({viewer, connection, hearing});
  speakers_changed_ = true;  // it has no choice yet
}

void VoiceRelay::forget(ViewerId viewer) {
  std::erase_if(listeners_, [viewer](const Listener& listener) { return listener.id == viewer; });
  if (muted_.contains(viewer)) set_muted(viewer, false);
  end(viewer);
}

void VoiceRelay::set_muted(ViewerId viewer, bool muted) {
  if (muted ? !muted_.insert(viewer).second : muted_.erase(viewer) == 0) return;
  has_changed_ = true;
  if (muted) end(viewer);
}

void VoiceRelay::end(ViewerId speaker) {
  if (std::erase_if(speakers_, [speaker](const Speaker& s) { return s.id == speaker; }) > 0)
    has_changed_ = speakers_changed_ = true;
}

std::vector<ConnectionId> VoiceRelay::receivers(ViewerId speaker, bool ends, RoomTime now,
                                                const HeadOf& head_of) {
  std::vector<ConnectionId> to;
  if (is_muted(speaker)) return to;
  auto known = std::ranges::find(speakers_, speaker, &Speaker::id);
  if (known == speakers_.end()) {
    known = speakers_.insert(known, {.id = speaker, .begun = now});
    has_changed_ = speakers_changed_ = true;
  }
  known->newest = now;
  const bool all_are_heard = speakers_.size() <= wire::kMaxSpeakersHeard;
  if (!all_are_heard) choose(now, head_of);
  to.reserve(listeners_.size());
  for (const Listener& listener : listeners_) {
    if (listener.id == speaker) continue;
    if (all_are_heard || listener.hearing == Hearing::kAll ||
        std::ranges::find(listener.heard, speaker) != listener.heard.end())
      to.push_back(listener.connection);
  }
  if (ends) end(speaker);
  return to;
}

void VoiceRelay::choose(RoomTime now, const HeadOf& head_of) {
  if (now - chosen_at_ < (speakers_changed_ ? kMinChoiceInterval : kChoiceInterval)) return;
  chosen_at_ = now;
  speakers_changed_ = false;
  for (Listener& listener : listeners_) listener.heard = nearest(listener.id, head_of);
}

std::vector<ViewerId> VoiceRelay::nearest(ViewerId listener, const HeadOf& head_of) const {
  struct Ranked {
    float distance_m;
    nanoseconds age;  // since it began to speak
    ViewerId id;
  };
  const auto own = head_of(listener);
  std::vector<Ranked> ranked;
  ranked.reserve(speakers_.size());
  for (const Speaker& speaker : speakers_) {
    if (speaker.id == listener) continue;
    ranked.push_back(
        {distance_m(own, head_of(speaker.id)), chosen_at_ - speaker.begun, speaker.id});
  }
  const std::size_t count = std::min(ranked.size(), wire::kMaxSpeakersHeard);
  std::ranges::partial_sort(ranked, ranked.begin() + static_cast<std::ptrdiff_t>(count), {},
                            [](const Ranked& r) { return std::tuple(r.distance_m, r.age, r.id); });
  std::vector<ViewerId> heard(count);
  std::ranges::transform(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(count),
                         heard.begin(), &Ranked::id);
  return heard;
}

bool VoiceRelay::is_speaking(ViewerId viewer) const {
  return std::ranges::find(speakers_, viewer, &Speaker::id) != speakers_.end();
}

wire::pb::Control VoiceRelay::message() const {
  wire::pb::Control control;
  wire::pb::Voices& voices = *control.mutable_voices();
  for (const Speaker& speaker : speakers_) voices.add_speaking(speaker.id.value);
  for (const ViewerId viewer : muted_) voices.add_muted(viewer.value);
  return control;
}

std::optional<wire::pb::Control> VoiceRelay::take(RoomTime now) {
  const auto paused = std::erase_if(
      speakers_, [now](const Speaker& speaker) { return now >= speaker.newest + kSilentAfter; });
  if (paused > 0) has_changed_ = speakers_changed_ = true;
  if (!has_changed_ || now < next_message_) return std::nullopt;
  has_changed_ = false;
  next_message_ = now + wire::kVoicesInterval;
  return message();
}

std::optional<RoomTime> VoiceRelay::next() const {
  std::optional<RoomTime> next;
  if (has_changed_) next = next_message_;
  for (const Speaker& speaker : speakers_) {
    const RoomTime pauses = speaker.newest + kSilentAfter;
    next = next ? std::min(*next, pauses) : pauses;
  }
  return next;
}

std::vector<ConnectionId> VoiceRelay::listeners() const {
  std::vector<ConnectionId> connections;
  connections.reserve(listeners_.size());
  for (const Listener& listener : listeners_) connections.push_back(listener.connection);
  return connections;
}

}  // namespace roomcast::hub
