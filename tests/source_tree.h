// SPDX-License-Identifier: Apache-2.0
// Reads the project's own C++ files as text, for tests of the source code. Single-threaded.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace roomcast::tests {

struct SourceFile {
  std::filesystem::path path;  // relative to the source tree, e.g. "roomcast/codec/varint.h"
  std::string text;
};

/// Every .h and .cpp under `folders` of the source tree at `root`, sorted by path. Missing folders
/// are left out.
[[nodiscard]] std::vector<SourceFile> read_cpp_files(const std::filesystem::path& root,
                                                     const std::vector<std::string>& folders);

/// The quoted includes of `text`, in order: "roomcast/core/result.h". Includes in <> belong to
/// other projects.
[[nodiscard]] std::vector<std::string> quoted_includes(const std::string& text);

}  // namespace roomcast::tests
