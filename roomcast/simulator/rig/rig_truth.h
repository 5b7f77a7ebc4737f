// SPDX-License-Identifier: Apache-2.0
// RigTruth: writes the ground truth of a simulated recording (layout: simulate_rig.h). Pictures may
// be written by any thread, everything else by one.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/dataset/rig_writer.h"

namespace roomcast::simulator {

inline constexpr int kTruthJpegQuality = 97;

/// What is true of a harsh sensor, beyond its pose and its lenses.
struct HarshTruth {
  double depth_scale = 1;  // true depth = depth_scale * reading
  std::string camera;      // model
  bool registers_color = false;
};

class RigTruth {
 public:
  /// Creates `directory` with the exact calibrations and poses of `sensors`. `harsh`: empty, or one
  /// for each sensor. kUnavailable on a disk error.
  static Result<RigTruth> create(const std::filesystem::path& directory, double fps,
                                 std::span<const recording::RigSensor> sensors,
                                 const std::string& source, bool with_color,
                                 std::span<const HarshTruth> harsh = {});

  [[nodiscard]] Status write_depth(std::size_t sensor, std::uint64_t frame, DepthView depth_mm,
                                   MaskView moving) const;
  [[nodiscard]] Status write_color(std::size_t sensor, std::uint64_t frame, ColorView color) const;

  /// Lists the capture time of frame number `frame` and the gains of linear light, red first, of
  /// its colour. Call in order of frames.
  [[nodiscard]] Status list(std::size_t sensor, std::uint64_t frame, nanoseconds true_time,
                            const std::array<float, 3>& gains) const;

 private:
  RigTruth(const std::filesystem::path& directory, std::span<const recording::RigSensor> sensors);
  [[nodiscard]] Status make_folders(std::size_t sensor, const SensorCalibration& calibration,
                                    bool with_color) const;

  std::vector<std::filesystem::path> folders_;  // by sensor
};

}  // namespace roomcast::simulator
