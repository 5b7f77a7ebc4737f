// SPDX-License-Identifier: Apache-2.0
// PoseRelay: where the people of a room are: takes the poses that viewers send of their heads and
// hands, and says what to tell everyone, and when. Everyone's pose goes to everyone, so the more
// moved the longer until they are told again. Pure. docs/spec/wire.md §3.
#pragma once

#include <optional>
#include <unordered_map>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

class PoseRelay {
 public:
  /// More than kMaxPosesPerSecond of one viewer are dropped.
  void set(ViewerId viewer, const wire::pb::ViewerPose& pose, RoomTime now);
  void forget(ViewerId viewer) { people_.erase(viewer); }
  /// Somebody new has come, who knows of no pose yet.
  void tell_all_again();

  /// The newest poses of those who moved; nothing when nobody did, or not yet. One message for all:
  /// a viewer skips its own pose.
  [[nodiscard]] std::optional<wire::pb::Control> take(RoomTime now);
  /// When take() will have something.
  [[nodiscard]] std::optional<RoomTime> next() const;

 private:
  struct Person {
    wire::pb::ViewerPose pose;
    bool is_news = false;
    RoomTime window_begin{};
    int poses_in_window = 0;
  };
  std::unordered_map<ViewerId, Person> people_;
  bool is_news_ = false;  // of somebody
  RoomTime next_{};
};

}  // namespace roomcast::hub
