// SPDX-License-Identifier: Apache-2.0
// PosePublisher: when to tell the hub where this viewer is: when it has moved, at most 20 times a
// second, and the last place always; and again when somebody new has come, who knows of no pose
// yet. Pure.
#pragma once

#include <chrono>
#include <optional>

#include "roomcast/client/room/person_pose.h"
#include "roomcast/core/clock.h"

namespace roomcast::viewer {

class PosePublisher {
 public:
  static constexpr std::chrono::milliseconds kInterval{50};

  void is(const client::PersonPose& pose);
  void tell_again() { is_news_ = true; }
  /// What to send now, if anything.
  [[nodiscard]] std::optional<client::PersonPose> take(HostTime now);

 private:
  std::optional<client::PersonPose> pose_;
  bool is_news_ = false;
  std::optional<HostTime> sent_;
};

}  // namespace roomcast::viewer
