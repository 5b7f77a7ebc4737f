// SPDX-License-Identifier: Apache-2.0
// PoseRelay: collects the head and hand poses that viewers send, and decides when to send which of
// them to everybody in the room. Every pose goes to every viewer, so the interval grows with the
// number of viewers that moved. Pure. docs/spec/wire.md §3.
#pragma once

#include <map>
#include <optional>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

class PoseRelay {
 public:
  /// Sets the newest pose of a viewer. Poses beyond kMaxPosesPerSecond of a viewer are dropped.
  void set(ViewerId viewer, const wire::pb::ViewerPose& pose, RoomTime now);
  void forget(ViewerId viewer) { people_.erase(viewer); }
  /// The head of a viewer, until the next call of set() or forget(); null: it has sent no pose.
  [[nodiscard]] const wire::pb::Pose* head_of(ViewerId viewer) const;
  /// Marks all poses as new, for a client that has just joined.
  void resend_all();

  /// The newest poses of the viewers that moved, at most kMaxPosesPerMessage; the others follow.
  /// Nothing: no pose has changed, or the next message is not yet due. All viewers get the same
  /// message and skip their own pose.
  [[nodiscard]] std::optional<wire::pb::Control> take(RoomTime now);
  /// The time from which take() returns a message; nothing: no pose has changed.
  [[nodiscard]] std::optional<RoomTime> next() const;

 private:
  struct Person {
    wire::pb::ViewerPose pose;
    bool has_changed = false;
    RoomTime window_begin{};
    int poses_in_window = 0;
  };
  std::map<ViewerId, Person> people_;
  ViewerId last_sent_{};      // where the next message goes on, so that nobody is left out
  bool has_changed_ = false;  // of any person
  RoomTime next_{};
};

}  // namespace roomcast::hub
