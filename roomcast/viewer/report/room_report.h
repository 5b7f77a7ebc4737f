// SPDX-License-Identifier: Apache-2.0
// RoomReport: the figures of the panel: rates, ages and drops of each sensor and of all. Pure.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/viewer/report/rate_meter.h"

namespace roomcast::viewer {

struct SensorFigures {
  SensorId id{};
  double fps = 0;                // arrived and decoded
  double megabytes_per_s = 0;    // 10^6 bytes
  double missed_per_s = 0;       // frames left out on their way, or not to be decoded
  std::uint64_t missed = 0;      // since the viewer began
  std::optional<double> age_ms;  // of the newest picture, since its capture
};

struct RoomFigures {
  double megabytes_per_s = 0;
  double sets_per_s = 0;
  std::vector<SensorFigures> sensors;  // as in the snapshot
};

class RoomReport {
 public:
  /// Often, whether or not there is a newer snapshot.
  void follow(const client::RoomSnapshot& room, HostTime now);
  [[nodiscard]] const RoomFigures& figures() const { return figures_; }

 private:
  struct SensorMeters {
    RateMeter frames, bytes, missed;
  };
  SensorFigures figures_of(const client::RoomSensor& sensor, const client::RoomSnapshot& room, HostTime now);

  RateMeter bytes_, sets_;
  std::map<SensorId, SensorMeters> meters_;
  RoomFigures figures_;
};

}  // namespace roomcast::viewer
