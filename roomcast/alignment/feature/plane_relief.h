// SPDX-License-Identifier: Apache-2.0
// How high the surface lies above a plane, place by place. Large planes of a room carry rugs,
// pictures and doors, a centimetre or two high, which belong to the plane as far as looks go, but
// whose features lie where they lie. Heights are means over a patch about as large as a feature, so
// that the noise of single readings does not get into them. Metres, in the depth camera's frame.
// Thread-safe (immutable after being made).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/view/depth_surface.h"
#include "roomcast/alignment/view/planes.h"

namespace roomcast::alignment {

class PlaneRelief {
 public:
  /// `samples` are the view's; those that are not near the plane are left out.
  PlaneRelief(const Plane& plane, std::span<const SurfacePoint> samples);

  /// Above the plane, towards the camera; nothing where no surface is near it.
  [[nodiscard]] std::optional<float> height_m(const Eigen::Vector3f& on_plane_m) const;

 private:
  struct Cell {
    float sum_m = 0;
    int count = 0;
  };
  struct Place {
    int column, row;
  };

  [[nodiscard]] Place place_of(const Eigen::Vector3f& point_m) const;
  [[nodiscard]] Cell around(const Place& place) const;

  Eigen::Vector3f right_, down_;  // unit, along the plane
  Place first_{};                 // of all samples: the lowest column and row
  int columns_ = 0, rows_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace roomcast::alignment
