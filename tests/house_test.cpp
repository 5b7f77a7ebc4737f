// SPDX-License-Identifier: Apache-2.0
// Two habits of the house that a machine can check: a licence line in every file, a test for every
// source.
#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/source_tree.h"

namespace roomcast::tests {
namespace {

constexpr std::string_view kLicenceLine = "// SPDX-License-Identifier: Apache-2.0";

/// Sources whose header no test beside them includes, and which test runs them instead.
const std::map<std::string_view, std::string_view> kTestedElsewhere = {
    {"roomcast/core/assert.cpp", "result_test.cpp reads the wrong side of a Result"},
};

bool has_licence(const SourceFile& file) {
  return file.text.compare(0, kLicenceLine.size(), kLicenceLine) == 0;
}

bool is_test(const std::filesystem::path& path) {
  const std::string stem = path.stem().string();
  return stem.size() > 5 && stem.compare(stem.size() - 5, 5, "_test") == 0;
}

/// The header that a source implements: by custom the first one it includes.
std::string header_of(const SourceFile& source) {
  const std::vector<std::string> includes = quoted_includes(source.text);
  return includes.empty() ? std::string() : includes.front();
}

/// True when a test in the same folder includes the header of `source`.
bool has_test_beside(const SourceFile& source, const std::vector<SourceFile>& files) {
  const std::string header = header_of(source);
  return std::any_of(files.begin(), files.end(), [&](const SourceFile& file) {
    if (!is_test(file.path) || file.path.parent_path() != source.path.parent_path()) return false;
    const std::vector<std::string> includes = quoted_includes(file.text);
    return std::find(includes.begin(), includes.end(), header) != includes.end();
  });
}

bool needs_test(const SourceFile& file) {
  return file.path.extension() == ".cpp" && !is_test(file.path) &&
         file.path.string().find("roomcast/cli/") != 0;  // driven as a program by tests/cli
}

std::vector<std::string> untested(const std::vector<SourceFile>& files) {
  std::vector<std::string> paths;
  for (const SourceFile& file : files) {
    if (needs_test(file) && !has_test_beside(file, files)) paths.push_back(file.path.string());
  }
  return paths;
}

TEST(House, every_file_begins_with_its_licence) {
  const auto files =
      read_cpp_files(ROOMCAST_SOURCE_DIR, {"roomcast", "web/wasm", "bench", "fuzz", "tests"});
  EXPECT_GT(files.size(), 10u);
  for (const SourceFile& file : files) EXPECT_TRUE(has_licence(file)) << file.path;
}

TEST(House, every_source_has_a_test_beside_it_or_a_reason) {
  for (const std::string& path : untested(read_cpp_files(ROOMCAST_SOURCE_DIR, {"roomcast"}))) {
    EXPECT_EQ(kTestedElsewhere.count(path), 1u)
        << path
        << ": no test in its folder includes its header; write one, or say here what tests it";
  }
}

TEST(House, no_reason_is_out_of_date) {
  const std::vector<std::string> paths =
      untested(read_cpp_files(ROOMCAST_SOURCE_DIR, {"roomcast"}));
  for (const auto& [path, reason] : kTestedElsewhere) {
    EXPECT_NE(std::find(paths.begin(), paths.end(), path), paths.end()) << path;
  }
}

TEST(House, notices_a_missing_licence) {
  EXPECT_FALSE(has_licence({"roomcast/core/made_up.h", "#pragma once\n"}));
}

TEST(House, notices_a_source_that_no_test_includes) {
  const SourceFile source{"roomcast/core/made_up.cpp", "#include \"roomcast/core/made_up.h\"\n"};
  const SourceFile other{"roomcast/core/other_test.cpp", "#include \"roomcast/core/other.h\"\n"};
  const SourceFile own{"roomcast/core/own_test.cpp", "#include \"roomcast/core/made_up.h\"\n"};
  EXPECT_EQ(untested({source, other}), std::vector<std::string>{"roomcast/core/made_up.cpp"});
  EXPECT_TRUE(untested({source, other, own}).empty());
}

}  // namespace
}  // namespace roomcast::tests
