// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/hub_report.h"

namespace roomcast::viewer {
namespace {

constexpr std::chrono::seconds kStatsInterval{1};

}  // namespace

void HubReport::follow(const client::RoomSnapshot& room) {
  const bool is_new = room.self != self_ || room.connected != connected_;
  if (is_new || room.people.size() > people_) pose_.send_again();
  self_ = room.self;
  connected_ = room.connected;
  people_ = room.people.size();
}

void HubReport::shown(const client::RoomSnapshot& room, HostTime now) {
  if (room.newest_set == newest_set_) return;
  newest_set_ = room.newest_set;
  shown_rate_.count(now, ++shown_);
}

void HubReport::send(const client::PersonPose& own, const std::optional<LatencyStages>& latency,
                     HostTime now) {
  pose_.set(own);
  if (connected_) {
    if (const auto pose = pose_.take(now)) hub_.send_pose(*pose);
  }
  if (now - stats_sent_ < kStatsInterval) return;
  stats_sent_ = now;
  shown_rate_.count(now, shown_);
  if (!connected_ || shown_ == 0) return;
  const double latency_ms = latency ? latency->total_ms.value_or(0) : 0;
  hub_.send_stats({newest_set_, shown_rate_.per_second(), latency_ms});
}

}  // namespace roomcast::viewer
