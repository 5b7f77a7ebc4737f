// SPDX-License-Identifier: Apache-2.0
// Habits of the house that a machine can check: a licence line in every file, a test for every
// source, and no time of day where time has to go on evenly.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/source_tree.h"

namespace roomcast::tests {
namespace {

constexpr std::string_view kLicenceLine = "// SPDX-License-Identifier: Apache-2.0";

const std::vector<std::string> kTestedFolders = {"roomcast", "bench", "tests"};

/// From a sensor to a viewer all time is monotonic: somebody who sets a clock disturbs nobody.
const std::vector<std::string> kTimelessFolders = {"roomcast/core",   "roomcast/wire",
                                                   "roomcast/net",    "roomcast/source",
                                                   "roomcast/client", "roomcast/hub"};

/// Tokens hold by the calendar.
constexpr std::string_view kWallClock = "roomcast/hub/access/wall_clock.cpp";

bool asks_the_time_of_day(const SourceFile& file) {
  if (file.path == kWallClock) return false;
  constexpr std::string_view kWays[] = {"system_clock", "utc_clock",      "gettimeofday(",
                                        "timespec_get", "CLOCK_REALTIME", "std::time("};
  return std::ranges::any_of(
      kWays, [&](std::string_view way) { return file.text.find(way) != std::string::npos; });
}

bool has_licence(const SourceFile& file) {
  return file.text.compare(0, kLicenceLine.size(), kLicenceLine) == 0;
}

bool is_test(const std::filesystem::path& path) {
  const std::string stem = path.stem().string();
  return stem.size() > 5 && stem.compare(stem.size() - 5, 5, "_test") == 0;
}

bool is_source(const SourceFile& file) {
  return file.path.extension() == ".cpp" && !is_test(file.path);
}

/// The header that a source implements: the one of its name. A source without one shares a header
/// with others: any of those of its folder that it includes.
std::vector<std::string> headers_of(const SourceFile& source, const std::set<std::string>& paths) {
  std::filesystem::path own = source.path;
  own.replace_extension(".h");
  if (paths.count(own.string()) > 0) return {own.string()};
  std::vector<std::string> headers = quoted_includes(source.text);
  std::erase_if(headers, [&](const std::string& header) {
    return std::filesystem::path(header).parent_path() != source.path.parent_path();
  });
  return headers;
}

/// What tests make use of in `folder`: the headers that those in the folder and in tests/ include,
/// the sources that implement these, what those include, and so on.
std::set<std::string> reached_by_tests(const std::filesystem::path& folder,
                                       const std::vector<SourceFile>& files) {
  std::vector<const SourceFile*> to_read;
  std::multimap<std::string, const SourceFile*> behind;  // what an include of this path leads to
  std::set<std::string> paths;
  for (const SourceFile& file : files) paths.insert(file.path.string());
  for (const SourceFile& file : files) {
    const std::filesystem::path place = file.path.parent_path();
    if (is_test(file.path)) {
      if (place == folder || place == "tests") to_read.push_back(&file);
    } else if (place == folder) {
      behind.emplace(file.path.string(), &file);
      if (!is_source(file)) continue;
      for (const std::string& header : headers_of(file, paths)) behind.emplace(header, &file);
    }
  }
  std::set<std::string> reached;
  while (!to_read.empty()) {
    const std::vector<std::string> includes = quoted_includes(to_read.back()->text);
    to_read.pop_back();
    for (const std::string& include : includes) {
      const auto [first, last] = behind.equal_range(include);
      for (auto found = first; found != last; ++found) {
        if (reached.insert(found->second->path.string()).second) to_read.push_back(found->second);
      }
    }
  }
  return reached;
}

/// The sources that no test makes use of. The command line is driven as a program, by
/// tests/cli.
std::vector<std::string> untested(const std::vector<SourceFile>& files) {
  std::map<std::filesystem::path, std::set<std::string>> reached;
  std::vector<std::string> paths;
  for (const SourceFile& file : files) {
    const std::filesystem::path folder = file.path.parent_path();
    if (!is_source(file) || folder == "roomcast/cli" || folder == "tests") continue;
    if (reached.count(folder) == 0) reached[folder] = reached_by_tests(folder, files);
    if (reached[folder].count(file.path.string()) == 0) paths.push_back(file.path.string());
  }
  return paths;
}

TEST(House, every_file_begins_with_its_licence) {
  const auto files =
      read_cpp_files(ROOMCAST_SOURCE_DIR, {"roomcast", "web/wasm", "bench", "fuzz", "tests"});
  EXPECT_GT(files.size(), 10u);
  for (const SourceFile& file : files) EXPECT_TRUE(has_licence(file)) << file.path;
}

TEST(House, every_source_is_used_by_a_test_beside_it) {
  EXPECT_THAT(untested(read_cpp_files(ROOMCAST_SOURCE_DIR, kTestedFolders)), testing::IsEmpty());
}

TEST(House, nothing_between_sensor_and_viewer_asks_the_time_of_day) {
  const auto files = read_cpp_files(ROOMCAST_SOURCE_DIR, kTimelessFolders);
  EXPECT_GT(files.size(), 10u);
  for (const SourceFile& file : files) EXPECT_FALSE(asks_the_time_of_day(file)) << file.path;
}

TEST(House, notices_who_asks_the_time_of_day) {
  EXPECT_TRUE(
      asks_the_time_of_day({"a.cpp", "const auto now = std::chrono::system_clock::now();"}));
  EXPECT_FALSE(
      asks_the_time_of_day({"a.cpp", "const auto now = std::chrono::steady_clock::now();"}));
}

TEST(House, notices_a_missing_licence) {
  EXPECT_FALSE(has_licence({"roomcast/core/example.h", "#pragma once\n"}));
}

TEST(House, notices_a_source_that_no_test_uses) {
  const SourceFile source{"roomcast/core/example.cpp", "#include \"roomcast/core/example.h\"\n"};
  const SourceFile other{"roomcast/core/other_test.cpp", "#include \"roomcast/core/other.h\"\n"};
  const SourceFile own{"roomcast/core/own_test.cpp", "#include \"roomcast/core/example.h\"\n"};
  EXPECT_EQ(untested({source, other}), std::vector<std::string>{"roomcast/core/example.cpp"});
  EXPECT_TRUE(untested({source, other, own}).empty());
}

TEST(House, finds_the_test_of_what_lies_behind_another_source) {
  const SourceFile inner{"roomcast/core/inner.cpp", "#include \"roomcast/core/inner.h\"\n"};
  const SourceFile outer{
      "roomcast/core/outer.cpp",
      "#include \"roomcast/core/outer.h\"\n#include \"roomcast/core/inner.h\"\n"};
  const SourceFile test{"roomcast/core/outer_test.cpp", "#include \"roomcast/core/outer.h\"\n"};
  EXPECT_TRUE(untested({inner, outer, test}).empty());
}

TEST(House, finds_the_test_of_sources_that_share_a_header) {
  const SourceFile shared{"roomcast/core/shapes.h", ""};
  const SourceFile other{"roomcast/core/brush.h", ""};
  const SourceFile round{
      "roomcast/core/round.cpp",
      "#include \"roomcast/core/brush.h\"\n#include \"roomcast/core/shapes.h\"\n"};
  const SourceFile test{"roomcast/core/shapes_test.cpp", "#include \"roomcast/core/shapes.h\"\n"};
  EXPECT_TRUE(untested({shared, other, round, test}).empty());
  EXPECT_EQ(untested({shared, other, round}), std::vector<std::string>{"roomcast/core/round.cpp"});
}

}  // namespace
}  // namespace roomcast::tests
