// SPDX-License-Identifier: Apache-2.0
// BundleCapture: makes a calibration bundle from the first frames of a sensor. About 30 depth
// pictures are kept, and a few colour pictures, spread evenly over them. Single-threaded.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "roomcast/alignment/bundle/calibration_bundle.h"

namespace roomcast::alignment {

inline constexpr std::size_t kBundleFrames = 30;
inline constexpr std::size_t kBundleColorFrames = 9;  // at most

class BundleCapture {
 public:
  BundleCapture(std::string name, const SensorCalibration& calibration);

  /// Adds a frame; `color` may be empty. Returns true when enough frames have been added.
  /// kInvalidArgument: a picture is not of its camera's size.
  [[nodiscard]] Result<bool> add(const DepthImage& depth_mm, const ColorImage& color);

  /// The bundle of the frames so far. kUnavailable before the first frame; else as `check`.
  [[nodiscard]] Result<CalibrationBundle> finish() const;

 private:
  void add_color(const ColorImage& color);

  std::string name_;
  SensorCalibration calibration_;
  std::vector<DepthImage> depth_mm_;
  std::vector<ColorImage> colors_;
  std::size_t seen_colors_ = 0;
  std::size_t colors_apart_ = 1;  // one in this many colour pictures is kept
};

}  // namespace roomcast::alignment
