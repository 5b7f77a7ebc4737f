// SPDX-License-Identifier: Apache-2.0
// HoleCompletion: fills what a sensor in live mode fills of its depth before it sends it. Large
// planes come first: the few readings of a glossy floor, once spread to those around them, would
// hide that its plane has a hole there. Single-threaded.
#pragma once

#include "roomcast/sensor/plane_completion.h"
#include "roomcast/sensor/sparse_completion.h"

namespace roomcast::sensor {

class HoleCompletion {
 public:
  explicit HoleCompletion(const SensorCalibration& calibration)
      : planes_(calibration), sparse_(calibration.depth.width, calibration.depth.height) {}

  /// As PlaneCompletion::complete, then as SparseCompletion::complete.
  void complete(DepthImage& depth_mm, ColorView color) {
    planes_.complete(depth_mm, color);
    sparse_.complete(depth_mm);
  }

 private:
  PlaneCompletion planes_;
  SparseCompletion sparse_;
};

}  // namespace roomcast::sensor
