// SPDX-License-Identifier: Apache-2.0
// SparseCompletion: depth between the scattered readings of a surface. Of dark, polished or hairy
// things only some pixels give a reading, others in every frame: a screen that somebody carries
// comes as specks. A pixel without a reading gets the depth of a plane through the readings around
// it, if the nearest ones in at least three of the four quadrants around it, up to 4 pixels away,
// lie on that plane. At the rim of the surface one quadrant is enough, if the readings in the other
// three stand close together: what they show would have been read in this pixel, too. So gaps
// through which something else is read stay open, and gaps of more than 7 pixels; holes in one
// piece stay open too, such as those beside the things that structured light sees, which come and
// go at their borders. It looks at single frames, so that it also fills what moves.
// Single-threaded; allocates only when it is made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::sensor {

class SparseCompletion {
 public:
  /// For pictures of this size, at most 32767 pixels along each side.
  SparseCompletion(int width, int height);

  /// Fills holes of `depth_mm`; leaves pictures of another size as they are.
  void complete(DepthImage& depth_mm);

  /// Pixels that were filled in the newest picture.
  [[nodiscard]] int filled() const { return static_cast<int>(fills_.size()); }

 private:
  struct Reading {
    std::uint16_t depth_mm = 0;
    std::int16_t x = 0, y = 0;  // small, because many are sorted
    bool in_piece = false;      // most pixels in the 3x3 around it have readings
  };
  /// A pixel without a reading, and the nearest reading in each quadrant around it.
  struct Hole {
    int x = 0, y = 0;
    std::array<Reading, 4> around;
    std::size_t quadrants = 0;  // with a reading
  };
  struct Cell {
    std::uint8_t readings = 0;
    std::uint8_t breaks = 0;  // pairs of neighbours, right or below in it, one without a reading
  };
  struct Fill {
    int x = 0, y = 0;
    std::uint16_t depth_mm = 0;
  };
  class Surface;

  [[nodiscard]] Reading reading_at(DepthView depth_mm, int x, int y) const;
  void count_readings(DepthView depth_mm);
  void find_pieces(DepthView depth_mm);
  [[nodiscard]] bool is_sparse(int left, int top) const;
  void find_holes(DepthView depth_mm, int left, int top);
  void find_readings(DepthView depth_mm, int left, int top);
  void fill_between_readings();
  void fill_holes(const Surface& surface);

  int width_, height_;
  Image<Cell> cells_;
  Image<std::uint8_t> in_piece_;   // 1: as Reading::in_piece
  std::vector<Hole> holes_;        // of one cell
  std::vector<Reading> readings_;  // around the cell
  std::vector<Fill> fills_;
};

}  // namespace roomcast::sensor
