// SPDX-License-Identifier: Apache-2.0
// Exports the sessions of a study as CSV files (RFC 4180), one for each kind of record, with a file
// that says what every column means. Single-threaded.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "roomcast/core/result.h"
#include "roomcast/study/study_folder.h"

namespace roomcast::study {

struct StudyExport {
  std::size_t participants = 0;
  std::map<std::string, std::size_t> rows;  // by file
};

/// Writes `out`/participants.csv, steps.csv, poses.csv, ..., data_dictionary.csv. Rows of sessions
/// have the participant and the condition in which they were written. kUnavailable: the folder
/// exists already or cannot be written. Also the errors of StudyFolder.
[[nodiscard]] Result<StudyExport> export_csv(const StudyFolder& study,
                                             const std::filesystem::path& out);

}  // namespace roomcast::study
