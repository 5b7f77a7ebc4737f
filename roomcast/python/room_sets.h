// SPDX-License-Identifier: Apache-2.0
// RoomSet: one frame set of a room, recorded or live, with what is known of its sensors. It is what
// Python's FrameSet and Frame stand for; arrays of its pictures keep it alive. Threading:
// immutable; point clouds are thread-safe.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/python/point_clouds.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::python {

/// The sensors of a room, as long as they do not change.
struct RoomSensors {
  explicit RoomSensors(std::vector<recording::SetSensor> all);

  const std::vector<recording::SetSensor> list;
  const std::unique_ptr<CloudMaker> clouds;                 // of all sensors
  const std::vector<std::unique_ptr<CloudMaker>> cloud_of;  // of one sensor by itself
};

struct RoomSet {
  std::shared_ptr<const RoomSensors> sensors;
  recording::FrameSet set;
  bool dated = false;               // its times are since 1970-01-01 UTC
  std::size_t sensors_sending = 0;  // those that a complete set has
  Status may_export;                // or the reason why not

  /// `sensor`: a name. Null if it is not in the set.
  [[nodiscard]] const recording::SetFrame* frame_of(const std::string& sensor) const;
};

using SharedSet = std::shared_ptr<const RoomSet>;

/// The points of all placed sensors, or of the frame with this index by itself.
[[nodiscard]] Result<std::shared_ptr<const recording::PointCloud>> cloud_of(
    const RoomSet& set, const recording::MergedCloudOptions& options);
[[nodiscard]] Result<std::shared_ptr<const recording::PointCloud>> cloud_of(
    const RoomSet& set, std::size_t frame, const recording::MergedCloudOptions& options);

}  // namespace roomcast::python
