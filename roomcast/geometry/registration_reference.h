// SPDX-License-Identifier: Apache-2.0
// A readable version of registration.h: the same result pixel by pixel in double precision through
// project(). Tests require that both agree; `roomcast bench register` compares their speed.
#pragma once

#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/registration.h"

namespace roomcast {

class RegistrationReference {
 public:
  /// Both must have been accepted by Registration::create.
  RegistrationReference(const SensorCalibration& calibration, const RegistrationOptions& options);

  /// Sizes must be those of the calibration.
  [[nodiscard]] RegisteredColor run(DepthView depth_mm, ColorView color) const;

 private:
  [[nodiscard]] Image<Eigen::Vector3d> project_all(DepthView depth_mm) const;
  [[nodiscard]] Image<double> nearest_surfaces(const Image<Eigen::Vector3d>& projected) const;
  [[nodiscard]] bool occluded(DepthView depth_mm, int x, int y, const Eigen::Vector3d& projected,
                              const Image<double>& nearest) const;

  SensorCalibration calibration_;
  RegistrationOptions options_;
  Image<Eigen::Vector2f> rays_;
  int cell_size_;
  int box_size_;
};

}  // namespace roomcast
