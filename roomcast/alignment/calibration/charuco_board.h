// SPDX-License-Identifier: Apache-2.0
// The calibration board: a chessboard with AprilTags in its white squares (ChArUco: An et al. 2018;
// family 36h11, numbered from 0, row by row; the top left square is black). The corners of the
// chessboard can be located to a fraction of a pixel, and the tags identify them, so that a part of
// the board suffices. Metres in the board's plane: x right, y down, from its top left corner.
// Thread-safe (no state).
#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/result.h"

namespace roomcast::alignment::calibration {

struct CharucoBoard {
  int columns = 7, rows = 5;  // squares
  double square_m = 0.053;

  /// The number of corners between four squares.
  [[nodiscard]] int corner_count() const { return (columns - 1) * (rows - 1); }
  /// The position of a corner; corners are numbered row by row.
  [[nodiscard]] Eigen::Vector2d corner_m(int corner) const;
  [[nodiscard]] Eigen::Vector2d size_m() const { return {columns * square_m, rows * square_m}; }
};

/// Side of a tag relative to that of its square; the rest is white.
inline constexpr double kTagShare = 0.7;

struct BoardTag {
  int id = 0;
  int column = 0, row = 0;  // of its square
};
[[nodiscard]] std::vector<BoardTag> tags_of(const CharucoBoard& board);

/// Corners of the black square: bottom left, bottom right, top right, top left.
[[nodiscard]] std::array<Eigen::Vector2d, 4> tag_corners_m(const CharucoBoard& board,
                                                           const BoardTag& tag);

/// Whether the print is black at this point. White outside the board.
[[nodiscard]] bool is_black(const CharucoBoard& board, const Eigen::Vector2d& point_m);

/// The largest board that fits a page, and the page as a PDF file.
struct BoardPage {
  double width_mm = 420, height_mm = 297;  // A3 across
};
inline constexpr BoardPage kA3Across{420, 297}, kA4Across{297, 210};
[[nodiscard]] CharucoBoard board_for(const BoardPage& page);
/// kInvalidArgument for a page on which squares would be smaller than 10 mm.
[[nodiscard]] Result<std::string> charuco_pdf(const BoardPage& page);

}  // namespace roomcast::alignment::calibration
