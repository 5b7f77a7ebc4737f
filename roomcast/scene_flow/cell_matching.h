// SPDX-License-Identifier: Apache-2.0
// Where the foreground of each cell was in an earlier picture: block matching of depth, which needs
// no light and no texture. A cell's neighbourhood of 7x7 cells moves as one, and may come nearer or
// go farther while it does. A first search in cells of twice the size covers long ways; the second
// is around what it found. Neighbours on one surface then agree by their median. Single-threaded;
// allocates only when the size changes.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/scene_flow/foreground_cells.h"

namespace roomcast::scene_flow {

/// From a cell of the newest picture to its place in the earlier one.
struct Displacement {
  float x = 0, y = 0;    // cells
  float farther_mm = 0;  // earlier depth less the newest
  float cost = 1;        // 0: looks the same there, to 1: nothing in common
};

inline constexpr int kMaxWay_cells = 16;

class CellMatcher {
 public:
  /// Both pictures have the same size. Searches for ways of `max_cells_at_1_m`, divided by the
  /// cell's depth in metres, but for at least two cells and at most kMaxWay_cells along each axis.
  /// The result has the pictures' size and is meaningful where `newest` has foreground. It is valid
  /// until the next call.
  const Image<Displacement>& match(const CellDepths& newest, const CellDepths& earlier,
                                   float max_cells_at_1_m);

 private:
  struct Match {
    int x = 0, y = 0;
    float farther_mm = 0;
    float cost = 0;
  };
  [[nodiscard]] Match best_of_coarse(int x, int y, int max_cells) const;
  template <class Costs>
  [[nodiscard]] Match best_start(int x, int y, const Costs& cost_of) const;
  [[nodiscard]] Displacement best_of_fine(int x, int y) const;
  void smooth(const CellDepths& newest);

  CellDepths coarse_newest_, coarse_earlier_;
  // With a border of cells without foreground, so that no search leaves the picture.
  CellDepths padded_newest_, padded_earlier_, padded_coarse_newest_, padded_coarse_earlier_;
  Image<Match> coarse_;
  Image<Displacement> found_, smooth_;
  std::vector<float> around_;
};

}  // namespace roomcast::scene_flow
