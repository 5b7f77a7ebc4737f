// SPDX-License-Identifier: Apache-2.0
// The lists of the TUM RGB-D benchmark layout: depth.txt and rgb.txt (a timestamp in seconds
// and a file per line, '#' starts a comment) and associations.txt (two such pairs per line).
// Thread-safe (no state).
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"

namespace roomcast::recording {

struct ListedFile {
  nanoseconds timestamp{};
  std::string file;  // as listed: relative to the list's folder
};

/// Returns the files in order of time. kNotFound, kTooLarge as read_file; kMalformed, naming file
/// and line, for lines not as above, times that do not increase, and files outside the folder.
[[nodiscard]] Result<std::vector<ListedFile>> read_tum_list(const std::filesystem::path& path);

/// Maps depth files to colour files. Either may come first in a line; `depth_files` identifies the
/// depth files. Errors as above.
[[nodiscard]] Result<std::map<std::string, std::string>> read_associations(
    const std::filesystem::path& path, const std::vector<ListedFile>& depth_files);

/// For each depth file, the colour file nearest in time, or an empty name if none is within
/// `tolerance`.
[[nodiscard]] std::vector<std::string> associate_by_time(const std::vector<ListedFile>& depth_files,
                                                         const std::vector<ListedFile>& color_files,
                                                         nanoseconds tolerance);

/// "103.231313" -> nanoseconds, exactly (no floating point). False for anything else.
[[nodiscard]] bool parse_seconds(std::string_view text, nanoseconds& time);

/// The inverse: seconds with nine decimals, which is exact for every time.
[[nodiscard]] std::string tum_seconds(nanoseconds time);

}  // namespace roomcast::recording
