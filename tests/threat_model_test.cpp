// SPDX-License-Identifier: Apache-2.0
// Checks that every test named in docs/threat-model.md exists.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::tests {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = ROOMCAST_SOURCE_DIR;

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool names_a_test(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.ends_with("_test.cpp") || name.ends_with(".test.mjs") || name.ends_with(".test.ts");
}

/// The text of all tests of the source tree.
std::string all_tests() {
  std::string text;
  for (const char* folder : {"roomcast", "tests", "web/src", "web/embed"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      if (entry.is_regular_file() && names_a_test(entry.path())) text += read_text(entry.path());
    }
  }
  return text;
}

struct Line {
  std::string threat;
  std::vector<std::string> tests;
  bool names_a_file = false;
};

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  for (std::size_t at = 1; at < row.size();) {
    const std::size_t end = std::min(row.find('|', at), row.size());
    cells.push_back(row.substr(at, end - at));
    at = end + 1;
  }
  return cells;
}

std::vector<std::string> quoted_in(const std::string& cell) {
  std::vector<std::string> names;
  for (std::size_t at = cell.find('`'); at != std::string::npos; at = cell.find('`', at)) {
    const std::size_t end = cell.find('`', at + 1);
    names.push_back(cell.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  return names;
}

/// The rows of the table, without its header, its rule and its headings.
std::vector<Line> threats() {
  std::vector<Line> lines;
  std::ifstream file(kRoot / "docs" / "threat-model.md");
  for (std::string row; std::getline(file, row);) {
    if (!row.starts_with("| ") || row.starts_with("| **") || row.starts_with("| threat")) continue;
    const auto cells = cells_of(row);
    if (cells.size() < 4) {
      ADD_FAILURE() << "this line has too few columns: " << row;
      continue;
    }
    const bool names_a_file = cells[2].find("tests/") != std::string::npos;
    lines.push_back({cells[0], quoted_in(cells[2]), names_a_file});
  }
  return lines;
}

TEST(ThreatModel, every_line_names_tests_that_exist) {
  const std::string tests = all_tests();
  const auto lines = threats();
  ASSERT_GT(lines.size(), 20U);
  for (const Line& line : lines) {
    EXPECT_TRUE(line.names_a_file || !line.tests.empty()) << line.threat << "names no test";
    for (const std::string& name : line.tests) {
      EXPECT_NE(tests.find(name), std::string::npos) << line.threat << "names " << name;
    }
  }
}

}  // namespace
}  // namespace roomcast::tests
