// SPDX-License-Identifier: Apache-2.0
// Classifies the pixels of a true view: surfaces seen by a sensor, surfaces whose colour is also
// seen by a sensor's colour camera, moving surfaces, and silhouettes (silhouette.h). After the
// baseline of this renderer: 6 cm + 2 % tolerance for a colour camera's line of sight; moving: a
// difference between two times of more than 10 grey levels or 3 cm, and 2 pixels around it.
#pragma once

#include <span>
#include <vector>

#include "bench/render/silhouette.h"
#include "bench/render/truth_view.h"
#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::bench {

/// One sensor at the time of a view: its true pose and noise-free depth.
struct TrueSensor {
  SensorCalibration calibration;
  RigidTransform world_from_depth;
  DepthImage depth_mm;
};

struct ViewClasses {
  MaskImage colored;  // seen by a sensor and by its colour camera
  MaskImage moving;
  Silhouette silhouette = {};  // without pixels where it is not known
};

/// Decides which points a colour camera sees, taking occlusion into account.
class ColorSight {
 public:
  explicit ColorSight(const TrueSensor& sensor);
  [[nodiscard]] bool sees(const Eigen::Vector3d& point_world) const;

 private:
  CameraIntrinsics color_;
  RigidTransform color_from_world_;
  Image<float> nearest_m_;  // of the surfaces, at a quarter of the picture's resolution
};

[[nodiscard]] ViewClasses classify(const TruthViewEntry& entry, const TruthView& now,
                                   const TruthView& other_instant,
                                   std::span<const ColorSight> sights,
                                   std::span<const StillBackground> backgrounds);

}  // namespace roomcast::bench
