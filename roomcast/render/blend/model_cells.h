// SPDX-License-Identifier: Apache-2.0
// ModelCells: the triangles of a piece of the model in cells, to find those that may fill holes of
// a picture: few of very many. Metres, world frame. Pure.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "roomcast/render/blend/hole_map.h"
#include "roomcast/render/view/eyes.h"

namespace roomcast::render {

using ModelTriangle = std::array<std::uint32_t, 3>;  // numbers of points

class ModelCells {
 public:
  ModelCells() = default;
  ModelCells(std::span<const Eigen::Vector3f> points_m, std::span<const ModelTriangle> triangles);

  /// Adds the triangles that face an eye and may cover a hole of its part of the picture, and maybe
  /// a few more.
  void add_near_holes(const Eyes& eyes, const HoleMap& holes,
                      std::vector<ModelTriangle>& near_holes) const;

 private:
  struct Cell {
    Eigen::AlignedBox3f box_m;
    std::size_t end = 0;  // of its triangles; they begin where the last cell's end
  };

  std::vector<Eigen::Vector3f> points_m_;
  std::vector<ModelTriangle> triangles_;
  std::vector<Cell> cells_;
};

}  // namespace roomcast::render
