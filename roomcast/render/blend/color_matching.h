// SPDX-License-Identifier: Apache-2.0
// ColorMatching: corrects colour differences between cameras (white balance, exposure). Computes a
// factor per sensor and channel from surfaces that two sensors both see: the median ratio of each
// pair, then log_gains() over all pairs. Runs on the CPU, on a fraction of the pictures.
// Single-threaded.
#pragma once

#include <map>
#include <optional>

#include <Eigen/Core>

#include "roomcast/core/ids.h"
#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/color_balance.h"
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
  /// Of the two cameras; it does not know their numbers.
  [[nodiscard]] static std::optional<ColorRatio> compare(const Picture& a, const Picture& b,
                                                         const RigidTransform& b_from_a);

  std::map<SensorId, Picture> pictures_;
  bool is_news_ = false;
};

}  // namespace roomcast::render
