// SPDX-License-Identifier: Apache-2.0
// Height of the surface above a plane, cell by cell. Large planes of a room carry rugs, pictures
// and doors, a centimetre or two high. They look like part of the plane, but their features must
// keep their true height. Heights are means over a patch about as large as a feature, which
// suppresses the noise of single readings. Metres, in the depth camera's frame. Thread-safe
// (immutable after being made).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/view/depth_surface.h"
#include "roomcast/alignment/view/planes.h"

namespace roomcast::alignment {

/// Chosen by hand: the height of a rug, a picture or a door, over the size of a feature (ADR 13).
struct PlaneReliefOptions {
  float cell_m = 0.04F;  // heights are means over 3 x 3 cells
  /// Higher surfaces are not part of the plane: a constant, and a share of depth.
  float highest_m = 0.05F, highest_per_depth = 0.01F;
  float min_cosine = 0.85F;  // between a sample's normal and the plane's
  int min_samples = 3;       // of a height

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("cell_m", cell_m, Range{0.001, 10});
    visit("highest_m", highest_m, Range{0, 1});
    visit("highest_per_depth", highest_per_depth, Range{0, 1});
    visit("min_cosine", min_cosine, Range{-1, 1});
    visit("min_samples", min_samples, Range{1, 1000});
  }
  [[nodiscard]] Status check() const { return check_fields("PlaneReliefOptions", *this); }
};

class PlaneRelief {
 public:
  /// `samples`: all samples of the view; those that are not near the plane are ignored.
  PlaneRelief(const Plane& plane, std::span<const SurfacePoint> samples,
              const PlaneReliefOptions& options = {});

  /// Height above the plane, towards the camera; nothing where no surface is near the plane.
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

  float cell_m_;
  int min_samples_;
  Eigen::Vector3f right_, down_;  // unit, along the plane
  Place first_{};                 // lowest column and row of all samples
  int columns_ = 0, rows_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace roomcast::alignment
