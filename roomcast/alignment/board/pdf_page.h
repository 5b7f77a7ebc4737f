// SPDX-License-Identifier: Apache-2.0
// A PDF file of one page of exact size (PDF 1.4, ISO 32000 subset), for boards to print.
// Thread-safe (no state).
#pragma once

#include <string>

namespace roomcast::alignment {

inline constexpr double kPointsPerMm = 72 / 25.4;

/// The file's bytes. `drawing`: PDF's drawing operators, in points from the bottom left; /F1 is
/// Helvetica.
[[nodiscard]] std::string pdf_page(double width_mm, double height_mm, const std::string& drawing);

}  // namespace roomcast::alignment
