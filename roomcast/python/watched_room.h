// SPDX-License-Identifier: Apache-2.0
// WatchedRoom: a live room as Python's users have it, the Room of the module. Threading: used with
// the interpreter's lock.
#pragma once

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include <pybind11/pybind11.h>

#include "roomcast/client/subscriber.h"
#include "roomcast/client/voices/spoken_voice.h"
#include "roomcast/client/voices/voice_listener.h"
#include "roomcast/python/errors.h"
#include "roomcast/python/live_sets.h"
#include "roomcast/python/waiting.h"

namespace roomcast::python {

class WatchedRoom {
 public:
  using Steady = std::chrono::steady_clock;

  explicit WatchedRoom(std::unique_ptr<client::Subscriber> subscriber)
      : subscriber_(std::move(subscriber)) {}
  ~WatchedRoom() { close(); }
  WatchedRoom(const WatchedRoom&) = delete;
  WatchedRoom& operator=(const WatchedRoom&) = delete;

  /// Null at `until`, or where the room was closed meanwhile.
  [[nodiscard]] std::shared_ptr<RoomSet> wait_newer(Steady::time_point until) {
    std::uint64_t revision = revision_;
    while (const std::shared_ptr<client::Subscriber> subscriber = subscriber_) {
      const auto room = wait_a_moment(*subscriber, revision, until);
      check_signals();
      if (subscriber_ && room->newest_set > newest_set_) return take(*room);
      revision = room->revision;
      if (const auto failure = subscriber->failure()) throw Failure(*failure);
      if (Steady::now() >= until) return nullptr;
    }
    return nullptr;
  }

  /// Throws Failure where it is closed.
  [[nodiscard]] std::shared_ptr<const client::RoomSnapshot> snapshot() const {
    if (!subscriber_) throw Failure({ErrorCode::kClosed, "the room was closed"});
    return subscriber_->snapshot();
  }
  /// Likewise. Keeps the connection while a call uses it without the lock.
  [[nodiscard]] std::shared_ptr<client::Subscriber> subscriber() const {
    if (!subscriber_) throw Failure({ErrorCode::kClosed, "the room was closed"});
    return subscriber_;
  }
  client::VoiceListener listener;
  client::SpokenVoice spoken;
  [[nodiscard]] bool is_closed() const { return !subscriber_; }
  void close() {
    auto ends = std::exchange(subscriber_, nullptr);
    if (!ends) return;
    const WithoutGil without;
    ends = nullptr;
  }

 private:
  static std::shared_ptr<const client::RoomSnapshot> wait_a_moment(
      const client::Subscriber& subscriber, std::uint64_t revision, Steady::time_point until) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Steady::now());
    const WithoutGil without;
    return subscriber.wait_newer(revision,
                                 std::clamp(left, std::chrono::milliseconds(0), kSignalPeriod));
  }
  [[nodiscard]] std::shared_ptr<RoomSet> take(const client::RoomSnapshot& room) {
    newest_set_ = room.newest_set;
    revision_ = room.revision;
    return sets_.set_of(room);
  }

  std::shared_ptr<client::Subscriber> subscriber_;
  LiveRoomSets sets_;
  SetId newest_set_{};
  std::uint64_t revision_ = 0;
};

/// Adds Person, Mark and Voice, and the functions of Room about them and about sensors' places.
void add_people(pybind11::module_& module, pybind11::class_<WatchedRoom>& rooms);

}  // namespace roomcast::python
