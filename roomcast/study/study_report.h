// SPDX-License-Identifier: Apache-2.0
// Writes what a study says of its conditions: a page with a figure and a table of each measure, the
// figures as files for papers, and the numbers as CSV. Threading: no state.
#pragma once

#include <filesystem>
#include <string>

#include "roomcast/core/result.h"
#include "roomcast/study/condition_summary.h"

namespace roomcast::study {

/// An SVG drawing: a row for each condition, a dot for each participant, the mean with its 95 %
/// interval.
[[nodiscard]] std::string figure_svg(const Measure& measure,
                                     const std::vector<std::string>& conditions);

/// Writes `out`/report.html, summary.csv, and NAME.svg of each measure. kUnavailable: the folder
/// exists already or cannot be written.
[[nodiscard]] Status write_report(const ConditionSummary& summary,
                                  const std::filesystem::path& out);

}  // namespace roomcast::study
