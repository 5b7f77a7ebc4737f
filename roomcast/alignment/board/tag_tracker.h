// SPDX-License-Identifier: Apache-2.0
// TagTracker: finds AprilTags (Olson 2011; Wang & Olson 2016; family 36h11) in a colour picture and
// measures the 3-D positions of their corners. The directions of the corners come from the picture,
// their distance from the depth camera: a plane fitted to all readings on the tag. The pose of a
// single tag by its outline alone (PnP) is ambiguous and is not used. Metres, depth camera's frame.
// Single-threaded; some 20 ms of CPU per picture.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::alignment {

struct SeenTag {
  int id = 0;
  /// Corners of the black square, as printed: bottom left, bottom right, top right, top left.
  std::array<Eigen::Vector3d, 4> corners_m;
};

class TagTracker {
 public:
  /// `calibration` has been checked.
  explicit TagTracker(const SensorCalibration& calibration);
  ~TagTracker();
  TagTracker(TagTracker&&) noexcept;
  TagTracker& operator=(TagTracker&&) noexcept;

  /// Pictures of the cameras' sizes. Omits tags without depth and outlines that are not square in
  /// 3-D.
  [[nodiscard]] std::vector<SeenTag> find(DepthView depth_mm, ColorView color);

 private:
  struct Detector;
  std::unique_ptr<Detector> detector_;
};

}  // namespace roomcast::alignment
