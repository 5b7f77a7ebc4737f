// SPDX-License-Identifier: Apache-2.0
// BundleMonitor: supplies the calibration bundles of one sensor. It makes a bundle of the first
// frames, then checks that the sensor has not moved since; after a move it reports the move, and
// makes another bundle once the sensor is stationary. Single-threaded.
#pragma once

#include <optional>
#include <string>

#include "roomcast/alignment/bundle/bundle_capture.h"
#include "roomcast/alignment/motion/pose_change_detector.h"
#include "roomcast/core/result.h"
#include "roomcast/source/frame_source.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::sensor {

/// The changes to report to the hub.
struct BundleUpdate {
  bool moved = false;
  std::optional<wire::pb::CalibrationBundle> bundle;
};

class BundleMonitor {
 public:
  /// `depth_scale`: the factor by which the depth of all frames is already multiplied.
  BundleMonitor(std::string name, const SensorCalibration& calibration, double depth_scale = 1);

  /// Takes frames in the order of capture. Errors say why the sensor cannot be placed by what it
  /// sees; the next frames are another attempt.
  [[nodiscard]] Result<BundleUpdate> add(const source::CapturedFrame& frame);

  /// The valid bundle, if any.
  [[nodiscard]] const std::optional<alignment::CalibrationBundle>& bundle() const {
    return bundle_;
  }

 private:
  [[nodiscard]] Result<BundleUpdate> capture(const source::CapturedFrame& frame);
  [[nodiscard]] Result<BundleUpdate> finish();

  std::string name_;
  SensorCalibration calibration_;
  double depth_scale_;
  alignment::BundleCapture capture_;
  std::optional<alignment::CalibrationBundle> bundle_;
  std::optional<alignment::PoseChangeDetector> watch_;  // while there is a bundle
  bool was_moved_ = false;
};

}  // namespace roomcast::sensor
