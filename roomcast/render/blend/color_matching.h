// SPDX-License-Identifier: Apache-2.0
// ColorMatching: cameras of a room see the same wall in different colours (white balance,
// exposure). From what two sensors both see it finds a factor for each channel of each sensor that
// makes them agree: the median ratio of every pair, then least squares over all pairs, the mean of
// the factors' logarithms kept at nought. On the CPU, now and then. Single-threaded.
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
  /// Looks at every kEvery-th picture of a sensor. All of the lens's size.
  void offer(SensorId sensor, const CameraIntrinsics& lens, DepthView depth_mm, ColorView color,
             MaskView seen);
  void forget(SensorId sensor);

  /// Brings the factors up to date when there are new pictures; a change is followed over several
  /// of them.
  void update(const std::map<SensorId, RigidTransform>& world_from_depth);

  /// Red first; 1 while nothing is known.
  [[nodiscard]] Eigen::Vector3f gain(SensorId sensor) const;

  static constexpr int kEvery = 10;

 private:
  struct Picture {
    CameraIntrinsics lens;
    DepthImage depth_mm;
    ColorImage color;
    MaskImage seen;
    Eigen::Vector3f log_gain = Eigen::Vector3f::Zero();
    int skipped = kEvery;  // the first one is looked at
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
