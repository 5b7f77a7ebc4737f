// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/board/board_pdf.h"

#include <algorithm>

#include <fmt/format.h>

#include "roomcast/alignment/board/pdf_page.h"
#include "roomcast/alignment/board/tag_cells.h"

namespace roomcast::alignment {
namespace {

constexpr double kTextHeight_mm = 12;
constexpr double kSmallestCell_mm = 3;

double cell_mm(const BoardPage& page) {
  const double across_mm = std::min(page.width_mm, page.height_mm - kTextHeight_mm);
  return (across_mm - 2 * kPageMargin_mm) / kTagCells;
}

/// The tag's black cells as filled rectangles, joined along rows.
std::string black_cells(const TagCells& white, const BoardPage& page) {
  const double cell = cell_mm(page);
  const double left = (page.width_mm - kTagCells * cell) / 2;
  const double bottom = page.height_mm - kPageMargin_mm - kTagCells * cell;
  std::string drawing;
  for (std::size_t row = 0; row < white.size(); ++row) {
    for (std::size_t column = 0; column < white.size(); ++column) {
      const std::size_t begin = column;
      while (column < white.size() && !white[row][column]) ++column;
      if (column == begin) continue;
      drawing += fmt::format(
          "{:.4f} {:.4f} {:.4f} {:.4f} re f\n",
          kPointsPerMm * (left + static_cast<double>(begin) * cell),
          kPointsPerMm * (bottom + static_cast<double>(white.size() - 1 - row) * cell),
          kPointsPerMm * static_cast<double>(column - begin) * cell, kPointsPerMm * cell);
    }
  }
  return drawing;
}

std::string caption(const BoardPage& page) {
  return fmt::format(
      "BT /F1 9 Tf {:.2f} {:.2f} Td (roomcast board, AprilTag 36h11 number {}. Print at 100 %: the "
      "black "
      "square is {:.1f} mm wide. Glue it on something flat.) Tj ET\n",
      kPointsPerMm * kPageMargin_mm, kPointsPerMm * kPageMargin_mm, page.tag, tag_side_mm(page));
}

}  // namespace

double tag_side_mm(const BoardPage& page) {
  return kTagSquareCells * cell_mm(page);
}

Result<std::string> board_pdf(const BoardPage& page) {
  const auto cells = tag_cells(page.tag);
  if (!cells) {
    return Error{ErrorCode::kInvalidArgument,
                 fmt::format("tags are numbered 0 to {}", tag_count() - 1)};
  }
  if (!(cell_mm(page) >= kSmallestCell_mm))
    return Error{ErrorCode::kInvalidArgument, "the page is too small for a board"};
  return pdf_page(page.width_mm, page.height_mm, black_cells(*cells, page) + caption(page));
}

}  // namespace roomcast::alignment
