// SPDX-License-Identifier: Apache-2.0
// Merges all sensors of a frame set into one point cloud. If several sensors see the same surface,
// the points come from the sensor with the best view (most frontal, nearest), so no surface appears
// twice. World frame, metres; a set of a single unplaced sensor is in that sensor's frame.
// Single-threaded; reuses its memory.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "roomcast/core/result.h"
#include "roomcast/recording/export/depth_points.h"
#include "roomcast/recording/export/point_cloud.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

struct MergedCloudOptions {
  std::optional<Eigen::AlignedBox3f> crop_m;  // points outside are left out
  float voxel_m = 0;          // > 0: one point per cube of this size, the mean of its points
  bool keep_doubles = false;  // keep all points of all sensors

  /// kInvalidArgument for an empty box, or a voxel that is negative or above 1 m.
  [[nodiscard]] Status check() const;
};

class MergedCloud {
 public:
  MergedCloud(const std::vector<SetSensor>& sensors, MergedCloudOptions options);

  /// Replaces `cloud`. Unplaced sensors are left out, unless there is only one sensor.
  void merge(const FrameSet& set, PointCloud& cloud);

 private:
  struct Seen {
    const SetFrame* frame = nullptr;
    const DepthPoints* points = nullptr;
    Eigen::Isometry3f world_from_depth;
    Eigen::Isometry3f depth_from_world;
  };

  void see(const FrameSet& set);
  void add_points(std::size_t sensor, PointCloud& cloud) const;
  [[nodiscard]] bool another_sees_it_better(std::size_t sensor, const Eigen::Vector3f& world_m,
                                            const Eigen::Vector3f& normal, float quality) const;

  std::vector<DepthPoints> points_;  // by sensor
  MergedCloudOptions options_;
  std::vector<Seen> seen_;  // of the current set
};

/// Replaces the points in each cube by one: the mean of position, normal and colour.
void thin_out(PointCloud& cloud, float voxel_m);

}  // namespace roomcast::recording
