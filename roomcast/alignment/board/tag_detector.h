// SPDX-License-Identifier: Apache-2.0
// TagDetector: finds AprilTags (Olson 2011; Wang & Olson 2016; family 36h11) in a colour picture.
// Pixels, centres at whole numbers. Single-threaded; some 20 ms of CPU per picture.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/image.h"

namespace roomcast::alignment {

struct TagOutline {
  int id = 0;
  /// Corners of the black square, as printed: bottom left, bottom right, top right, top left.
  std::array<Eigen::Vector2d, 4> corners_px;
};

class TagDetector {
 public:
  /// Searches the picture reduced by the factor `decimate` and refines the corners at full
  /// resolution.
  explicit TagDetector(float decimate = 1.5F);
  ~TagDetector();
  TagDetector(TagDetector&&) noexcept;
  TagDetector& operator=(TagDetector&&) noexcept;

  [[nodiscard]] std::vector<TagOutline> find(ColorView color);
  /// The grey picture of the last `find`.
  [[nodiscard]] ImageView<const std::uint8_t> grey() const;

 private:
  struct Detector;
  std::unique_ptr<Detector> detector_;
};

}  // namespace roomcast::alignment
