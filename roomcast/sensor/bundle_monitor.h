// SPDX-License-Identifier: Apache-2.0
// BundleMonitor: the sensor's own part of being placed. Makes a calibration bundle of its first
// frames, then watches that the bundle still holds; when the sensor was moved it says so, and makes
// another one once it stands still. Single-threaded.
#pragma once

#include <optional>
#include <string>

#include "roomcast/alignment/bundle/bundle_capture.h"
#include "roomcast/alignment/motion/pose_change_detector.h"
#include "roomcast/core/result.h"
#include "roomcast/source/frame_source.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::sensor {

/// What the hub has to know.
struct BundleUpdate {
  bool moved = false;
  std::optional<wire::pb::CalibrationBundle> bundle;
};

class BundleMonitor {
 public:
  BundleMonitor(std::string name, const SensorCalibration& calibration);

  /// Frames in the order of their capture. Errors say why the sensor cannot be placed by what it
  /// sees; it tries again with the next frames.
  [[nodiscard]] Result<BundleUpdate> add(const source::CapturedFrame& frame);

  /// The one that holds, if any.
  [[nodiscard]] const std::optional<alignment::CalibrationBundle>& bundle() const { return bundle_; }

 private:
  [[nodiscard]] Result<BundleUpdate> capture(const source::CapturedFrame& frame);
  [[nodiscard]] Result<BundleUpdate> finish();

  std::string name_;
  SensorCalibration calibration_;
  alignment::BundleCapture capture_;
  std::optional<alignment::CalibrationBundle> bundle_;
  std::optional<alignment::PoseChangeDetector> watch_;  // while there is a bundle
  bool was_moved_ = false;
};

}  // namespace roomcast::sensor
