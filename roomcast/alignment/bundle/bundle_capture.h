// SPDX-License-Identifier: Apache-2.0
// BundleCapture: watches the first frames of a sensor and makes its calibration bundle of them.
// About 30 depth pictures are kept, and few colour pictures, evenly spread over them.
// Single-threaded.
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

  /// Takes a frame; `color` may be empty. True when enough have been seen. Frames of another size
  /// than the cameras' are kInvalidArgument.
  [[nodiscard]] Result<bool> add(const DepthImage& depth_mm, const ColorImage& color);

  /// The bundle of what has been seen so far. kUnavailable before the first frame; else as `check`.
  [[nodiscard]] Result<CalibrationBundle> finish() const;

 private:
  void add_color(const ColorImage& color);

  std::string name_;
  SensorCalibration calibration_;
  std::vector<DepthImage> depth_mm_;
  std::vector<ColorImage> colors_;
  std::size_t seen_colors_ = 0;
  std::size_t colors_apart_ = 1;  // of those seen every so many are kept
};

}  // namespace roomcast::alignment
