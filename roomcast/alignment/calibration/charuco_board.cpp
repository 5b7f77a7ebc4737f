// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/calibration/charuco_board.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "roomcast/alignment/board/pdf_page.h"
#include "roomcast/alignment/board/tag_cells.h"

namespace roomcast::alignment::calibration {
namespace {

using alignment::kPointsPerMm;
using alignment::kTagSquareCells;

constexpr double kMargin_mm = 10;  // margin that printers leave white
constexpr double kCaption_mm = 8;
constexpr double kSmallestSquare_mm = 10;

bool is_black_square(int column, int row) {
  return (column + row) % 2 == 0;
}

/// The outer ring of a tag's cells is white and is outside its black square.
constexpr int kRim = (alignment::kTagCells - kTagSquareCells) / 2;

std::string rectangle(double left_mm, double top_mm, double width_mm, double height_mm,
                      const BoardPage& page) {
  return fmt::format("{:.4f} {:.4f} {:.4f} {:.4f} re f\n", kPointsPerMm * left_mm,
                     kPointsPerMm * (page.height_mm - top_mm - height_mm), kPointsPerMm * width_mm,
                     kPointsPerMm * height_mm);
}

std::string draw_tag(const alignment::TagCells& white, double left_mm, double top_mm,
                     double cell_mm, const BoardPage& page) {
  std::string drawing;
  for (int row = 0; row < kTagSquareCells; ++row) {
    for (int column = 0; column < kTagSquareCells; ++column) {
      const auto& cells = white[static_cast<std::size_t>(row + kRim)];
      if (cells[static_cast<std::size_t>(column + kRim)]) continue;
      drawing +=
          rectangle(left_mm + column * cell_mm, top_mm + row * cell_mm, cell_mm, cell_mm, page);
    }
  }
  return drawing;
}

}  // namespace

Eigen::Vector2d CharucoBoard::corner_m(int corner) const {
  return {(corner % (columns - 1) + 1) * square_m, (corner / (columns - 1) + 1) * square_m};
}

std::vector<BoardTag> tags_of(const CharucoBoard& board) {
  std::vector<BoardTag> tags;
  for (int row = 0; row < board.rows; ++row) {
    for (int column = 0; column < board.columns; ++column) {
      if (is_black_square(column, row)) continue;
      tags.push_back({static_cast<int>(tags.size()), column, row});
    }
  }
  return tags;
}

std::array<Eigen::Vector2d, 4> tag_corners_m(const CharucoBoard& board, const BoardTag& tag) {
  const double margin = 0.5 * (1 - kTagShare) * board.square_m;
  const double left = tag.column * board.square_m + margin;
  const double top = tag.row * board.square_m + margin;
  const double side = kTagShare * board.square_m;
  return {Eigen::Vector2d(left, top + side), Eigen::Vector2d(left + side, top + side),
          Eigen::Vector2d(left + side, top), Eigen::Vector2d(left, top)};
}

bool is_black(const CharucoBoard& board, const Eigen::Vector2d& point_m) {
  const Eigen::Vector2d in_squares = point_m / board.square_m;
  const int column = static_cast<int>(std::floor(in_squares.x()));
  const int row = static_cast<int>(std::floor(in_squares.y()));
  if (column < 0 || row < 0 || column >= board.columns || row >= board.rows) return false;
  if (is_black_square(column, row)) return true;
  const Eigen::Vector2d in_tag =
      (in_squares - Eigen::Vector2d(column, row)).array() - 0.5 * (1 - kTagShare);
  const Eigen::Vector2d cell = in_tag / kTagShare * kTagSquareCells;
  if (cell.minCoeff() < 0 || cell.maxCoeff() >= kTagSquareCells) return false;
  const int white_squares_before = row * board.columns / 2 + column / 2;
  const auto cells = alignment::tag_cells(white_squares_before);
  if (!cells) return false;
  return !(
      *cells)[static_cast<std::size_t>(cell.y()) + kRim][static_cast<std::size_t>(cell.x()) + kRim];
}

CharucoBoard board_for(const BoardPage& page) {
  CharucoBoard board;
  const double square_mm = std::min((page.width_mm - 2 * kMargin_mm) / board.columns,
                                    (page.height_mm - 2 * kMargin_mm - kCaption_mm) / board.rows);
  board.square_m = 0.001 * std::floor(square_mm);
  return board;
}

Result<std::string> charuco_pdf(const BoardPage& page) {
  const CharucoBoard board = board_for(page);
  const double square_mm = 1000 * board.square_m;
  if (!(square_mm >= kSmallestSquare_mm))
    return Error{ErrorCode::kInvalidArgument, "the page is too small for a board"};
  const double left = 0.5 * (page.width_mm - 1000 * board.size_m().x()), top = kMargin_mm;
  std::string drawing;
  for (int row = 0; row < board.rows; ++row) {
    for (int column = 0; column < board.columns; ++column) {
      if (!is_black_square(column, row)) continue;
      drawing +=
          rectangle(left + column * square_mm, top + row * square_mm, square_mm, square_mm, page);
    }
  }
  for (const BoardTag& tag : tags_of(board)) {
    const auto corners = tag_corners_m(board, tag);
    drawing += draw_tag(*alignment::tag_cells(tag.id), left + 1000 * corners[3].x(),
                        top + 1000 * corners[3].y(), kTagShare * square_mm / kTagSquareCells, page);
  }
  drawing += fmt::format(
      "BT /F1 9 Tf {:.2f} {:.2f} Td (roomcast calibration board, {} x {} squares. Print at 100 %: "
      "squares are {:.0f} mm wide. Glue it on something flat.) Tj ET\n",
      kPointsPerMm * left, kPointsPerMm * kMargin_mm, board.columns, board.rows, square_mm);
  return alignment::pdf_page(page.width_mm, page.height_mm, drawing);
}

}  // namespace roomcast::alignment::calibration
