// SPDX-License-Identifier: Apache-2.0
// The project's own C++ files as text, for the tests that read it. Single-threaded.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace roomcast::tests {

struct SourceFile {
  std::filesystem::path path;  // relative to the source tree, e.g. "roomcast/codec/varint.h"
  std::string text;
};

/// Every .h and .cpp under `folders` of the source tree at `root`, sorted by path. Folders that are
/// not there are left out.
[[nodiscard]] std::vector<SourceFile> read_cpp_files(const std::filesystem::path& root,
                                                     const std::vector<std::string>& folders);

/// What `text` includes in quotes, in order: "roomcast/core/result.h". Includes in <> are other
/// people's.
[[nodiscard]] std::vector<std::string> quoted_includes(const std::string& text);

}  // namespace roomcast::tests
