// SPDX-License-Identifier: Apache-2.0
// Finds the corners of a ChArUco board in a colour picture: the tags give approximate positions,
// the image gradients around each corner refine them (Foerstner 1987, as in OpenCV's cornerSubPix).
// Pixels, centres at whole numbers. Single-threaded; some 50 ms of CPU per picture.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/board/tag_detector.h"
#include "roomcast/alignment/calibration/charuco_board.h"
#include "roomcast/core/image.h"

namespace roomcast::alignment::calibration {

struct SeenCorner {
  int corner = 0;  // of the board
  Eigen::Vector2d pixel;
};

class CharucoFinder {
 public:
  explicit CharucoFinder(const CharucoBoard& board);

  /// The visible corners in the board's order; empty if there is no board.
  [[nodiscard]] std::vector<SeenCorner> find(ColorView color);

 private:
  CharucoBoard board_;
  std::vector<BoardTag> tags_;
  alignment::TagDetector detector_;
};

}  // namespace roomcast::alignment::calibration
