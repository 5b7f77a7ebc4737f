// SPDX-License-Identifier: Apache-2.0
// HubReport: a viewer's reports to the hub: the viewer's pose, at a limited rate, and once a second
// statistics of how well it keeps up.
#pragma once

#include "roomcast/client/subscriber.h"
#include "roomcast/viewer/report/latency_budget.h"
#include "roomcast/viewer/report/rate_meter.h"
#include "roomcast/viewer/walk/pose_publisher.h"

namespace roomcast::viewer {

class HubReport {
 public:
  /// `hub` must outlive this.
  explicit HubReport(client::Subscriber& hub) : hub_(hub) {}

  /// Sends the pose again after a reconnection and to newly arrived people, who have not received
  /// it.
  void follow(const client::RoomSnapshot& room);
  /// Counts a drawn frame set.
  void shown(const client::RoomSnapshot& room, HostTime now);
  /// Call it once per iteration; sends the reports that are due.
  void send(const client::PersonPose& own, const std::optional<LatencyStages>& latency,
            HostTime now);

  [[nodiscard]] double shown_per_s() const { return shown_rate_.per_second(); }

 private:
  client::Subscriber& hub_;
  PosePublisher pose_;
  ViewerId self_{};
  std::size_t people_ = 0;
  bool connected_ = false;
  SetId newest_set_{};
  std::uint64_t shown_ = 0;
  RateMeter shown_rate_;
  HostTime stats_sent_{};
};

}  // namespace roomcast::viewer
