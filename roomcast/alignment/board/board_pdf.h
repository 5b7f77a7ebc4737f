// SPDX-License-Identifier: Apache-2.0
// The board to print: one AprilTag (family 36h11) as large as the page allows, as a PDF page of
// exact size (PDF 1.4, ISO 32000 subset: rectangles and a line of text). Millimetres. Thread-safe
// (no state).
#pragma once

#include <string>

#include "roomcast/core/result.h"

namespace roomcast::alignment {

struct BoardPage {
  double width_mm = 210, height_mm = 297;  // A4
  int tag = 0;
};
inline constexpr BoardPage kA4{210, 297, 0}, kA3{297, 420, 0};
/// Margin that printers leave white.
inline constexpr double kPageMargin_mm = 10;

/// The side of the black square.
[[nodiscard]] double tag_side_mm(const BoardPage& page);

/// The file's bytes. kInvalidArgument for a tag that the family does not have, or a page too small.
[[nodiscard]] Result<std::string> board_pdf(const BoardPage& page);

}  // namespace roomcast::alignment
