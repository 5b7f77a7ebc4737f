// SPDX-License-Identifier: Apache-2.0
// One point cloud of all sensors of a frame set. Where several see the same surface the one that
// sees it best gives the points (straightest, nearest), so that nothing is there twice. World
// frame, metres; a set of a single sensor that nobody has placed is in that sensor's frame.
// Single-threaded; keeps its memory from set to set.
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
  std::optional<Eigen::AlignedBox3f> crop_m;  // what is outside is left out
  float voxel_m = 0;          // more than 0: one point for each cube of this size, their mean
  bool keep_doubles = false;  // every sensor's every point

  /// kInvalidArgument for an empty box, or a voxel that is negative or above 1 m.
  [[nodiscard]] Status check() const;
};

class MergedCloud {
 public:
  MergedCloud(const std::vector<SetSensor>& sensors, MergedCloudOptions options);

  /// Replaces `cloud`. Sensors that nobody has placed are left out, unless there is but one.
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

/// One point for each cube that has any: the mean of place, normal and colour.
void thin_out(PointCloud& cloud, float voxel_m);

}  // namespace roomcast::recording
