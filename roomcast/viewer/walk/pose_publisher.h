// SPDX-License-Identifier: Apache-2.0
// PosePublisher: decides when to send the viewer's pose to the hub: after a change, at most 20
// times a second, and always the last pose. Sends it again when new people arrive, who have not
// received it. Pure.
#pragma once

#include <chrono>
#include <optional>

#include "roomcast/client/room/person_pose.h"
#include "roomcast/core/clock.h"

namespace roomcast::viewer {

class PosePublisher {
 public:
  static constexpr std::chrono::milliseconds kInterval{50};

  void set(const client::PersonPose& pose);
  void send_again() { is_unsent_ = true; }
  /// The pose to send now, if any.
  [[nodiscard]] std::optional<client::PersonPose> take(HostTime now);

 private:
  std::optional<client::PersonPose> pose_;
  bool is_unsent_ = false;
  std::optional<HostTime> sent_;
};

}  // namespace roomcast::viewer
