// SPDX-License-Identifier: Apache-2.0
#include "tests/source_tree.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

namespace roomcast::tests {
namespace {

bool is_cpp(const std::filesystem::path& path) {
  return path.extension() == ".h" || path.extension() == ".cpp";
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

std::vector<SourceFile> read_cpp_files(const std::filesystem::path& root,
                                       const std::vector<std::string>& folders) {
  std::vector<SourceFile> files;
  for (const std::string& folder : folders) {
    std::error_code absent;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder, absent)) {
      if (!entry.is_regular_file() || !is_cpp(entry.path())) continue;
      files.push_back({entry.path().lexically_relative(root), read_text(entry.path())});
    }
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

std::vector<std::string> quoted_includes(const std::string& text) {
  std::vector<std::string> includes;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "#") words >> word;
    if (word != "#include" && word != "include") continue;
    const std::size_t open = line.find('"');
    const std::size_t close = line.rfind('"');
    if (open != close) includes.push_back(line.substr(open + 1, close - open - 1));
  }
  return includes;
}

}  // namespace roomcast::tests
