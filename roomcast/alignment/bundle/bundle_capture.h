// SPDX-License-Identifier: Apache-2.0
// BundleCapture: makes a calibration bundle from the first frames of a sensor. About 30 depth
// pictures are kept, and a few colour pictures, spread evenly over them. Single-threaded.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/alignment/bundle/calibration_bundle.h"
#include "roomcast/alignment/bundle/steady_depth.h"

namespace roomcast::alignment {

inline constexpr std::size_t kBundleFrames = 30;

struct BundleCaptureOptions {
  std::size_t frames = kBundleFrames;  // a second; in the prototype 30 gained a tenth over one
  std::size_t color_frames = 9;        // at most; so that a person leaves no trace (ADR 12)
  SteadyDepthOptions steady_depth;
  DepthInstantOptions instants;
  BundleCheckOptions usable;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("frames", frames, Range{1, 1000});
    visit("color_frames", color_frames, Range{1, 100});
    visit("steady_depth", steady_depth);
    visit("instants", instants);
    visit("usable", usable);
  }
  [[nodiscard]] Status check() const { return check_fields("BundleCaptureOptions", *this); }
};

class BundleCapture {
 public:
  BundleCapture(std::string name, const SensorCalibration& calibration,
                const BundleCaptureOptions& options = {});

  /// Adds a frame; `color` may be empty. `time_s` is on a clock that the sensors of the rig share;
  /// with it the frame becomes an instant of the bundle. Returns true when enough frames have been
  /// added. kInvalidArgument: a picture is not of its camera's size.
  [[nodiscard]] Result<bool> add(const DepthImage& depth_mm, const ColorImage& color,
                                 std::optional<double> time_s = std::nullopt);

  /// The bundle of the frames so far. kUnavailable before the first frame; else as `check`.
  [[nodiscard]] Result<CalibrationBundle> finish() const;

 private:
  void add_color(const ColorImage& color);

  std::string name_;
  SensorCalibration calibration_;
  BundleCaptureOptions options_;
  std::vector<DepthImage> depth_mm_;
  std::vector<double> times_s_;  // one of each depth picture, or fewer
  std::vector<ColorImage> colors_;
  std::size_t seen_colors_ = 0;
  std::size_t colors_apart_ = 1;  // one in this many colour pictures is kept
};

}  // namespace roomcast::alignment
