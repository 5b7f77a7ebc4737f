// SPDX-License-Identifier: Apache-2.0
// Calibrates one sensor from views of a board: the colour camera's lens, the pose of the depth
// camera relative to it, and scale and bias of its readings. The depth camera's lens is taken as
// given: the board's print is not visible in depth. Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/alignment/calibration/charuco_finder.h"
#include "roomcast/alignment/calibration/depth_fit.h"
#include "roomcast/alignment/calibration/lens_fit.h"
#include "roomcast/io/camera_json.h"

namespace roomcast::alignment::calibration {

struct BoardView {
  std::vector<SeenCorner> corners;
  DepthImage depth_mm;
};

struct CalibrationReport {
  io::RecordedCamera camera;  // for camera.json
  LensFit lens;
  DepthFit depth;
};

/// `start`: the initial calibration, the manufacturer's or nominal. Errors of fit_lens and
/// fit_depth.
[[nodiscard]] Result<CalibrationReport> calibrate(const CharucoBoard& board,
                                                  const std::vector<BoardView>& views,
                                                  const SensorCalibration& start, bool keep_lens);

}  // namespace roomcast::alignment::calibration
