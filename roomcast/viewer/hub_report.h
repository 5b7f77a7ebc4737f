// SPDX-License-Identifier: Apache-2.0
// HubReport: what a viewer tells the hub: where its person is, at a bounded rate, and once a second
// how well it can show what comes.
#pragma once

#include "roomcast/client/subscriber.h"
#include "roomcast/viewer/report/latency_budget.h"
#include "roomcast/viewer/report/rate_meter.h"
#include "roomcast/viewer/walk/pose_publisher.h"

namespace roomcast::viewer {

class HubReport {
 public:
  /// `hub` outlives it.
  explicit HubReport(client::Subscriber& hub) : hub_(hub) {}

  /// Whoever has just come, or is there after a new connection, knows of no pose yet.
  void follow(const client::RoomSnapshot& room);
  /// A newer room was drawn.
  void shown(const client::RoomSnapshot& room, HostTime now);
  /// Once per round; sends what is due.
  void tell(const client::PersonPose& own, const std::optional<LatencyStages>& latency, HostTime now);

  [[nodiscard]] double shown_per_s() const { return shown_rate_.per_second(); }

 private:
  client::Subscriber& hub_;
  PosePublisher own_;
  ViewerId self_{};
  std::size_t people_ = 0;
  bool connected_ = false;
  SetId newest_set_{};
  std::uint64_t shown_ = 0;
  RateMeter shown_rate_;
  HostTime stats_sent_{};
};

}  // namespace roomcast::viewer
