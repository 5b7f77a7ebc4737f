// SPDX-License-Identifier: Apache-2.0
// SceneFlow: how fast what stands before one sensor's background moves, and where to.
// Sensors take their pictures at different times; with the motion, what moves can be drawn where it
// was at one instant. From two pictures of depth in a row (CellMatcher). Single-threaded.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/scene_flow/cell_matching.h"
#include "roomcast/scene_flow/foreground_cells.h"

namespace roomcast::scene_flow {

/// The motion of the foreground in one cell of a depth picture, kCellPixels wide and high.
struct CellFlow {
  /// Metres per second, in the sensor's frame (x right, y down, z forward).
  Eigen::Vector3f velocity = Eigen::Vector3f::Zero();
  /// Only surfaces nearer than this move, in metres along z; 0: none.
  float limit_m = 0;
};
using FlowField = Image<CellFlow>;

/// A person at 1.5 m fills about 2000 cells of a picture of 512x424.
inline constexpr int kMaxForegroundCells = 2500;

class SceneFlow {
 public:
  explicit SceneFlow(const CameraIntrinsics& depth);

  /// Takes the sensor's next picture; one of another size than the lens only ends the motion.
  /// Nothing moves in the first one, in one that is not newer than the last or by more than 0.25 s,
  /// and while most of what is read is foreground, because then the sensor itself was moved; nor
  /// while the foreground has more than kMaxForegroundCells cells, so that the time is bounded.
  void take(DepthView depth_mm, RoomTime capture_time);

  [[nodiscard]] const CameraIntrinsics& lens() const { return lens_; }
  /// In the newest picture. By cells: cells_along() the picture's sides.
  [[nodiscard]] const FlowField& field() const { return field_; }
  /// The same; null while nothing moves.
  [[nodiscard]] const FlowField* motion() const { return is_still_ ? nullptr : &field_; }

 private:
  void find_velocities(double seconds);
  void grow();

  CameraIntrinsics lens_;
  ForegroundFinder finder_;
  CellMatcher matcher_;
  CellDepths newest_, earlier_;
  std::optional<RoomTime> time_;
  FlowField field_, grown_;
  bool is_still_ = true;
};

}  // namespace roomcast::scene_flow
