// SPDX-License-Identifier: Apache-2.0
// What is true of the still surfaces of a simulated rig, where a camera looks: their depth, and
// which of them a sensor saw. From the sensors' own places, and from places without a sensor.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/recording/dataset/rig_json.h"

namespace roomcast::bench {

struct StillTruth {
  CameraIntrinsics camera;
  RigidTransform world_from_camera;
  DepthImage depth_mm;  // 0 where nothing is, or nothing that stands still
  MaskImage readings;   // of that surface by a sensor, up to 255
};

/// A surface was seen when so many frames of a sensor read it.
inline constexpr int kMinReadings = 3;

/// Of one sensor: the median of its noise-free pictures where most of them agree; nothing is read
/// yet. kNotFound without a truth folder; errors of its files.
[[nodiscard]] Result<StillTruth> read_sensor_truth(const std::filesystem::path& rig,
                                                   const recording::RigSensorEntry& sensor,
                                                   const CameraIntrinsics& camera);

/// Counts the readings of a frame of that sensor: those within 5 cm or 3 % of the truth.
void add_readings(DepthView depth_mm, StillTruth& truth);

/// From the free viewpoints of the rig, where the same surface is there at both instants. Its
/// readings are those of the sensor in `sensors` that read it most, within 2 cm or 1 %. Empty for a
/// rig without such views.
[[nodiscard]] Result<std::vector<StillTruth>> read_view_truths(const std::filesystem::path& rig,
                                                               std::span<const StillTruth> sensors);

}  // namespace roomcast::bench
