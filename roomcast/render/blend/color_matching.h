// SPDX-License-Identifier: Apache-2.0
// ColorMatching: corrects colour differences between cameras (white balance, exposure). Computes a
// factor per sensor and channel from surfaces that two sensors both see: the median ratio of each
// pair, then least squares over all pairs with a prior that keeps the factors near 1. Runs on the
// CPU, on a fraction of the pictures. Single-threaded.
#pragma once

#include <map>
#include <optional>

#include <Eigen/Core>

#include "roomcast/core/ids.h"
#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::render {

class ColorMatching {
 public:
  /// Uses every kEvery-th picture of a sensor. All images have the size of `lens`.
  void offer(SensorId sensor, const CameraIntrinsics& lens, DepthView depth_mm, ColorView color,
             MaskView seen);
  void forget(SensorId sensor);

  /// Recomputes the factors if there are new pictures. A change is applied over several updates.
  void update(const std::map<SensorId, RigidTransform>& world_from_depth);

  /// Factors, red first; 1 while nothing is known.
  [[nodiscard]] Eigen::Vector3f gain(SensorId sensor) const;

  static constexpr int kEvery = 10;

 private:
  struct Picture {
    CameraIntrinsics lens;
    DepthImage depth_mm;
    ColorImage color;
    MaskImage seen;
    Eigen::Vector3f log_gain = Eigen::Vector3f::Zero();
    int skipped = kEvery;  // so that the first picture is used
  };
  struct PairRatio {
    double places = 0;
    Eigen::Vector3d log_b_over_a;
  };
  [[nodiscard]] static std::optional<PairRatio> compare(const Picture& a, const Picture& b,
                                                        const RigidTransform& b_from_a);

  std::map<SensorId, Picture> pictures_;
  bool is_news_ = false;
};

}  // namespace roomcast::render
