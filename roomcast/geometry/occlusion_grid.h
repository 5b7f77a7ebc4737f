// SPDX-License-Identifier: Apache-2.0
// A coarse z-buffer over the colour picture: the z of the nearest surface read by the depth camera,
// in and around each cell. Cells are about as wide as the gap between neighbouring depth pixels in
// the picture. A look-up covers the 3x3 cells around a position, so that surfaces have no holes and
// extend past their last depth pixel: the true edge is somewhere before the next one. Picture
// positions in pixels, z in metres. Single-threaded.
#pragma once

#include <cstdint>
#include <vector>

namespace roomcast {

class OcclusionGrid {
 public:
  /// Picture sides and cells must be at least one pixel.
  OcclusionGrid(int picture_width, int picture_height, int cell_size);

  /// Removes all surfaces.
  void clear();

  /// Enters the surfaces of a row of pixels at (u, v), each inside the picture (-0.5 <= u <= width
  /// - 0.5), and writes the cell of each. A pixel with z <= 0 is not a surface; its cell is one in
  /// which everything is occluded.
  void splat_row(const float* u, const float* v, const float* z_m, int count, std::int32_t* cells);

  /// Writes the cells only.
  void find_cells(const float* u, const float* v, const float* z_m, int count,
                  std::int32_t* cells) const;

  /// Call after the last surface and before `nearest_m`.
  void finish();

  /// z of the nearest surface in the cell and its eight neighbours.
  [[nodiscard]] float nearest_m(std::int32_t cell) const {
    return nearest_m_[static_cast<std::size_t>(cell)];
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x);
  }

  int columns_, rows_;  // with a border of one cell all around
  float cells_per_pixel_;
  std::vector<float> splatted_m_;  // nearest z in each cell
  std::vector<float> across_m_;    // the same over three cells of a row
  std::vector<float> nearest_m_;   // and over three rows
};

}  // namespace roomcast
