// SPDX-License-Identifier: Apache-2.0
// What the pixels of a true view show: surfaces that some sensor sees, those whose colour some
// sensor's colour camera sees as well, and those that move. After the baseline that this renderer
// is compared with: 6 cm + 2 % tolerance for a colour camera's line of sight; moving: what differs
// between two instants by more than 10 grey levels or 3 cm, and 2 pixels around it.
#pragma once

#include <span>
#include <vector>

#include "bench/render/truth_view.h"
#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::bench {

/// One sensor at the instant of a view: where it really was, and depth without error.
struct TrueSensor {
  SensorCalibration calibration;
  RigidTransform world_from_depth;
  DepthImage depth_mm;
};

struct ViewClasses {
  MaskImage colored;  // some sensor sees it and its colour camera, too
  MaskImage moving;
};

/// Which points a colour camera sees past the surfaces before them.
class ColorSight {
 public:
  explicit ColorSight(const TrueSensor& sensor);
  [[nodiscard]] bool sees(const Eigen::Vector3d& point_world) const;

 private:
  CameraIntrinsics color_;
  RigidTransform color_from_world_;
  Image<float> nearest_m_;  // of the surfaces, on a quarter of the picture's resolution
};

[[nodiscard]] ViewClasses classify(const TruthViewEntry& entry, const TruthView& now,
                                   const TruthView& other_instant,
                                   std::span<const ColorSight> sights);

}  // namespace roomcast::bench
