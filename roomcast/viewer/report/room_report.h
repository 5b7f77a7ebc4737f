// SPDX-License-Identifier: Apache-2.0
// RoomReport: the panel's figures: rates, ages and drops of each sensor and in total. Pure.
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
  double fps = 0;                // received and decoded
  double megabytes_per_s = 0;    // 10^6 bytes
  double missed_per_s = 0;       // frames lost on the way or not decodable
  std::uint64_t missed = 0;      // since the viewer started
  std::optional<double> age_ms;  // of the newest picture, since capture
};

struct RoomFigures {
  double megabytes_per_s = 0;
  double sets_per_s = 0;
  std::vector<SensorFigures> sensors;  // in the snapshot's order
};

class RoomReport {
 public:
  /// Call it often, also without a new snapshot.
  void follow(const client::RoomSnapshot& room, HostTime now);
  [[nodiscard]] const RoomFigures& figures() const { return figures_; }

 private:
  struct SensorMeters {
    RateMeter frames, bytes, missed;
  };
  SensorFigures figures_of(const client::RoomSensor& sensor, const client::RoomSnapshot& room,
                           HostTime now);

  RateMeter bytes_, sets_;
  std::map<SensorId, SensorMeters> meters_;
  RoomFigures figures_;
};

}  // namespace roomcast::viewer
