// SPDX-License-Identifier: Apache-2.0
// ToldViews: what a room has told its sensors of the cones in which its viewers see (WatchedFrom),
// and when it tells them anew: at most 10 times a second, and only what has changed noticeably,
// however often a viewer's head moves. Pure. docs/spec/wire.md §3 "Only what a viewer looks at".
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/hub/visibility/view_visibility.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

/// A sensor that takes views, and has a pose.
struct ViewTaker {
  SensorId sensor;
  RigidTransform world_from_depth;
};

class ToldViews {
 public:
  static constexpr std::chrono::milliseconds kInterval{100};
  /// A head that has not moved for so long is at rest: what was told ahead of it no longer holds.
  static constexpr std::chrono::milliseconds kSettling{350};

  /// A head has moved, or a viewer or a sensor has come or gone.
  void expect_change(RoomTime now);
  /// The time for the next update() if nothing else happens before; nothing: none is needed.
  [[nodiscard]] std::optional<RoomTime> next() const;

  struct News {
    SensorId sensor;
    wire::pb::WatchedFrom watched;
  };
  /// The messages to send now. `cones` are those of all viewers, in the world; without any, or with
  /// more than a message takes, sensors send everything. That is told at once, everything else when
  /// it is due. Sensors that are no takers are told once that they send everything.
  [[nodiscard]] std::vector<News> update(const std::vector<ViewCone>& cones,
                                         const std::vector<ViewTaker>& takers, RoomTime now);
  /// It has joined anew, and knows nothing.
  void forget_sensor(SensorId sensor) { told_.erase(sensor); }

 private:
  std::map<SensorId, wire::pb::WatchedFrom> told_;  // without those that send everything
  RoomTime updated_{};
  std::optional<RoomTime> due_, settles_;
};

}  // namespace roomcast::hub
