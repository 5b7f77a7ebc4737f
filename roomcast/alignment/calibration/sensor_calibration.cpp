// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/calibration/sensor_calibration.h"

#include <utility>

namespace roomcast::alignment::calibration {

Result<CalibrationReport> calibrate(const CharucoBoard& board, const std::vector<BoardView>& views,
                                    const SensorCalibration& start, bool keep_lens) {
  std::vector<std::vector<SeenCorner>> corners;
  for (const BoardView& view : views) corners.push_back(view.corners);
  auto lens = fit_lens(board, corners, start.color, keep_lens);
  if (!lens) return lens.error();

  SensorCalibration cameras = start;
  cameras.color = lens->camera;
  if (cameras.color_is_registered) cameras.depth = cameras.color;
  std::vector<BoardDepth> planes;
  for (std::size_t i = 0; i < views.size(); ++i)
    planes.push_back({&views[i].depth_mm, lens->camera_from_board[i]});
  auto depth = fit_depth(board, planes, cameras);
  if (!depth) return depth.error();

  if (!cameras.color_is_registered) cameras.color_from_depth = depth->model.color_from_depth;
  constexpr double kMetresPerMillimetre = 0.001;
  io::RecordedCamera camera;
  camera.calibration = cameras;
  camera.depth_scale_to_metre = kMetresPerMillimetre * depth->model.scale;
  camera.depth_bias_m = depth->model.bias_m;
  return CalibrationReport{std::move(camera), *std::move(lens), *std::move(depth)};
}

}  // namespace roomcast::alignment::calibration
