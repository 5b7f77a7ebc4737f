// SPDX-License-Identifier: Apache-2.0
// Selects the frames of a sensor that serve as views of the board: at least kMinCorners corners are
// visible, the board is held still (depth and colour are not captured at exactly the same time),
// and it is at a new place. Single-threaded.
#pragma once

#include <vector>

#include "roomcast/alignment/calibration/charuco_finder.h"
#include "roomcast/alignment/calibration/sensor_calibration.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::alignment::calibration {

class ViewCollector {
 public:
  explicit ViewCollector(const CharucoBoard& board);

  enum class Verdict { kNoBoard, kMoving, kSeenBefore, kTaken };
  Verdict add(const source::CapturedFrame& frame);

  [[nodiscard]] const std::vector<BoardView>& views() const { return views_; }
  /// The corners of the last frame.
  [[nodiscard]] const std::vector<SeenCorner>& corners() const { return last_; }

  static constexpr std::size_t kMinCorners = 10;
  static constexpr double kStill_px = 0.7;
  static constexpr double kElsewhere = 0.05;  // of the picture's width, from earlier views

 private:
  CharucoFinder finder_;
  std::vector<SeenCorner> last_;
  std::vector<BoardView> views_;
};

/// Root mean square distance between the corners that both contain; nothing if there are fewer than
/// four.
[[nodiscard]] std::optional<double> way_px(const std::vector<SeenCorner>& a,
                                           const std::vector<SeenCorner>& b);

}  // namespace roomcast::alignment::calibration
