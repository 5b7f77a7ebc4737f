// SPDX-License-Identifier: Apache-2.0
// Habits of the house that a machine can check: a licence line in every file, a test for every
// source, a namespace for every wing, no word that was retired, and no time of day where time has
// to go on evenly.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
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
const std::vector<std::string> kTimelessFolders = {
    "roomcast/core",   "roomcast/wire", "roomcast/net",    "roomcast/source",
    "roomcast/client", "roomcast/hub",  "roomcast/sensor", "roomcast/simulator"};

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

/// The first two folders of a path: "roomcast/hub" of "roomcast/hub/room/room.cpp", "bench/align".
std::filesystem::path wing_of(const std::filesystem::path& path) {
  std::filesystem::path wing;
  int names = 0;
  for (const auto& name : path.parent_path()) {
    if (names++ < 2) wing /= name;
  }
  return wing;
}

/// The files of `wing` that tests use: the headers that tests of the wing and of tests/ include,
/// the sources that implement these headers, the headers that these sources include, and so on.
std::set<std::string> reached_by_tests(const std::filesystem::path& wing,
                                       const std::vector<SourceFile>& files) {
  std::vector<const SourceFile*> to_read;
  std::multimap<std::string, const SourceFile*> behind;  // what an include of this path leads to
  std::set<std::string> paths;
  for (const SourceFile& file : files) paths.insert(file.path.string());
  for (const SourceFile& file : files) {
    const std::filesystem::path place = wing_of(file.path);
    if (is_test(file.path)) {
      if (place == wing || place == "tests") to_read.push_back(&file);
    } else if (place == wing) {
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

/// The sources that no test makes use of. The command line is driven as a program, by tests/cli,
/// and Python's module from Python, by roomcast/python/tests.
std::vector<std::string> untested(const std::vector<SourceFile>& files) {
  std::map<std::filesystem::path, std::set<std::string>> reached;
  std::vector<std::string> paths;
  for (const SourceFile& file : files) {
    const std::filesystem::path wing = wing_of(file.path);
    if (!is_source(file) || wing == "roomcast/cli" || wing == "roomcast/python" || wing == "tests")
      continue;
    if (reached.count(wing) == 0) reached[wing] = reached_by_tests(wing, files);
    if (reached[wing].count(file.path.string()) == 0) paths.push_back(file.path.string());
  }
  return paths;
}

/// The namespace of a folder below roomcast/: its wing; core and geometry are the words everybody
/// uses, and are roomcast itself.
std::string namespace_of(const std::filesystem::path& path) {
  const std::string wing = wing_of(path).filename().string();
  return wing == "core" || wing == "geometry" ? "roomcast" : "roomcast::" + wing;
}

/// The outermost namespaces that a file opens, as they are written.
std::vector<std::string> opened_namespaces(const std::string& text) {
  static const std::regex kOpened("(^|\\n)namespace ([A-Za-z_:]+) \\{");
  std::vector<std::string> names;
  for (std::sregex_iterator at(text.begin(), text.end(), kOpened), end; at != end; ++at) {
    names.push_back((*at)[2]);
  }
  return names;
}

bool is_in_its_namespace(const SourceFile& file) {
  const std::string own = namespace_of(file.path);
  return std::ranges::all_of(opened_namespaces(file.text), [&](const std::string& name) {
    const bool is_nested = name.starts_with(own + "::") && own != "roomcast";
    return name == own || is_nested || !name.starts_with("roomcast");
  });
}

/// A word and what is used instead; tests/retired_words.txt.
struct RetiredWord {
  std::string word, instead;
};

std::vector<RetiredWord> retired_words() {
  std::ifstream file(std::filesystem::path(ROOMCAST_SOURCE_DIR) / "tests/retired_words.txt");
  std::vector<RetiredWord> words;
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with('#') || colon == std::string::npos) continue;
    words.push_back({line.substr(0, colon), line.substr(colon + 2)});
  }
  return words;
}

/// Whether `text` has the word by itself, or as a part of a longer name: Thinker in ThinkerTest,
/// room_hall in room_hall_, but neither in a longer word.
bool has_word(const std::string& text, const std::string& word) {
  const auto is_letter = [&](std::size_t at) {
    return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
  };
  const auto is_lower = [&](std::size_t at) {
    return at < text.size() && std::islower(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const bool begins = at == 0 || !is_letter(at - 1) || text[at - 1] == 'k';
    if (begins && !is_lower(at + word.size())) return true;
  }
  return false;
}

bool is_text(const std::filesystem::path& path) {
  static const std::set<std::string> kKinds = {".cpp",  ".h",   ".proto", ".ts",   ".mjs",
                                               ".md",   ".txt", ".frag",  ".vert", ".comp",
                                               ".glsl", ".c",   ".py",    ".pyi"};
  return kKinds.contains(path.extension().string());
}

/// All that people read: code, its tests and documents.
std::vector<SourceFile> read_texts() {
  const std::filesystem::path root(ROOMCAST_SOURCE_DIR);
  std::vector<SourceFile> files;
  for (const char* folder :
       {"roomcast", "bench", "tests", "fuzz", "examples", "web/src", "web/wasm", "docs"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file() || !is_text(entry.path())) continue;
      if (entry.path().filename() == "retired_words.txt") continue;
      if (entry.path() == root / "tests/house_test.cpp") continue;  // its examples
      std::ifstream stream(entry.path());
      files.push_back({std::filesystem::relative(entry.path(), root),
                       {std::istreambuf_iterator<char>(stream), {}}});
    }
  }
  return files;
}

TEST(House, no_file_has_a_word_that_was_retired) {
  const auto words = retired_words();
  const auto files = read_texts();
  EXPECT_GT(words.size(), 30u);
  EXPECT_GT(files.size(), 1000u);
  for (const SourceFile& file : files) {
    for (const RetiredWord& retired : words) {
      EXPECT_FALSE(has_word(file.text, retired.word))
          << file.path << ": " << retired.word << " is " << retired.instead << " now";
    }
  }
}

TEST(House, notices_a_word_that_was_retired) {
  EXPECT_TRUE(has_word("class WidgetTest {", "Widget"));
  EXPECT_TRUE(has_word("old_widget_.close();", "old_widget"));
  EXPECT_TRUE(has_word("constexpr int kWidgetEyes = 2;", "Widget"));
  EXPECT_FALSE(has_word("midgetwidget", "widget"));
  EXPECT_FALSE(has_word("widgets", "widget"));
}

TEST(House, every_wing_has_its_namespace) {
  const auto files = read_cpp_files(ROOMCAST_SOURCE_DIR, {"roomcast"});
  EXPECT_GT(files.size(), 10u);
  for (const SourceFile& file : files) EXPECT_TRUE(is_in_its_namespace(file)) << file.path;
}

TEST(House, notices_a_namespace_of_another_wing) {
  EXPECT_TRUE(is_in_its_namespace(
      {"roomcast/hub/federation/a.h", "#pragma once\n\nnamespace roomcast::hub::federation {\n"}));
  EXPECT_FALSE(is_in_its_namespace({"roomcast/hub/room/a.h", "\nnamespace roomcast {\n"}));
  EXPECT_FALSE(is_in_its_namespace({"roomcast/core/a.h", "\nnamespace roomcast::core {\n"}));
}

TEST(House, every_file_begins_with_its_licence) {
  const auto files =
      read_cpp_files(ROOMCAST_SOURCE_DIR, {"roomcast", "web/wasm", "bench", "fuzz", "tests"});
  EXPECT_GT(files.size(), 10u);
  for (const SourceFile& file : files) EXPECT_TRUE(has_licence(file)) << file.path;
}

TEST(House, every_source_is_used_by_a_test_of_its_wing) {
  EXPECT_THAT(untested(read_cpp_files(ROOMCAST_SOURCE_DIR, kTestedFolders)), testing::IsEmpty());
}

TEST(House, no_code_between_sensor_and_viewer_uses_the_time_of_day) {
  const auto files = read_cpp_files(ROOMCAST_SOURCE_DIR, kTimelessFolders);
  EXPECT_GT(files.size(), 10u);
  for (const SourceFile& file : files) EXPECT_FALSE(asks_the_time_of_day(file)) << file.path;
}

TEST(House, notices_a_use_of_the_time_of_day) {
  EXPECT_TRUE(
      asks_the_time_of_day({"a.cpp", "const auto now = std::chrono::system_clock::now();"}));
  EXPECT_FALSE(
      asks_the_time_of_day({"a.cpp", "const auto now = std::chrono::steady_clock::now();"}));
}

/// What throws or goes unnoticed when it cannot be written: cli/print.h is for that.
bool prints_past_the_one_place(const SourceFile& file) {
  return file.text.find("fmt::print(") != std::string::npos ||
         file.text.find("std::cerr") != std::string::npos;
}

TEST(House, one_place_writes_to_people) {
  for (const SourceFile& file : read_cpp_files(ROOMCAST_SOURCE_DIR, {"roomcast"}))
    EXPECT_FALSE(prints_past_the_one_place(file)) << file.path;
  EXPECT_TRUE(prints_past_the_one_place({"a.cpp", "  fmt::print(stderr, line);"}));
  EXPECT_FALSE(prints_past_the_one_place({"a.cpp", "  print_err(line);"}));
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

TEST(House, finds_the_test_of_a_source_behind_another_one) {
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
