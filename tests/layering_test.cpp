// SPDX-License-Identifier: Apache-2.0
// Which folder may include which. Each folder below roomcast/ that holds sources is a layer of its
// own, however deep it is. A layer uses only layers above it in layers.h, so there is no cycle at
// any depth; a second test finds cycles in the includes themselves, without the table.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/layers.h"
#include "tests/source_tree.h"

namespace roomcast::tests {
namespace {

std::set<std::string> words(std::string_view text) {
  std::istringstream stream{std::string(text)};
  std::set<std::string> found;
  for (std::string word; stream >> word;) found.insert(word);
  return found;
}

/// Code that no program contains: tests, and what several of them share.
bool is_test_code(const std::filesystem::path& path) {
  const std::string name = path.filename().string(), all = path.string();
  return name.ends_with("_test.cpp") || name.ends_with("_fixture.h") ||
         name == "write_golden_frames.cpp" || all.find("/testing/") != std::string::npos ||
         all.find("/test_runtime/") != std::string::npos;
}

/// The layer a file is in, as the table names it: "hub/room", "bench".
std::string layer_name(const std::filesystem::path& path) {
  const std::string folder = path.parent_path().generic_string();
  constexpr std::string_view kTop = "roomcast/";
  if (folder.starts_with(kTop)) return folder.substr(kTop.size());
  return folder.starts_with("bench") ? "bench" : folder;
}

const Layer* find_layer(const std::string& name) {
  const auto found = std::ranges::find(kLayers, name, &Layer::folder);
  return found == kLayers.end() ? nullptr : &*found;
}

bool may_use(const Layer& user, const std::string& used, bool is_test) {
  if (used == user.folder) return true;
  const auto allows = [&](std::string_view list) {
    const std::set<std::string> allowed = words(list);
    if (allowed.contains(used)) return true;
    return allowed.contains("*") && used != "cli" && used != "bench" && used != "fuzz";
  };
  return allows(user.may_use) || (is_test && allows(user.tests_may_use));
}

/// One sentence for each include of `file` that the table does not allow.
std::vector<std::string> forbidden_includes(const SourceFile& file) {
  const std::string path = file.path.generic_string();
  const Layer* user = find_layer(layer_name(file.path));
  if (!user) return {path + " is in a folder that has no row in the table"};
  std::vector<std::string> sentences;
  for (const std::string& include : quoted_includes(file.text)) {
    const std::string used = layer_name(include);
    if (!find_layer(used)) {
      sentences.push_back(path + " includes \"" + include +
                          "\", which is not a path from the top of the tree into a known folder");
    } else if (!may_use(*user, used, is_test_code(file.path))) {
      sentences.push_back(path + " includes \"" + include + "\", but " + std::string(user->folder) +
                          " may not use " + used);
    }
  }
  return sentences;
}

using Graph = std::map<std::string, std::set<std::string>>;

/// Folders below roomcast/, cut off after `depth` names, and the folders that they include.
Graph folder_graph(const std::vector<SourceFile>& files, int depth) {
  const auto folder_of = [depth](const std::filesystem::path& path) {
    std::filesystem::path folder;
    int names = 0;
    for (const auto& name : path.parent_path()) {
      if (names++ <= depth) folder /= name;  // the first is roomcast/ itself
    }
    return folder.generic_string();
  };
  Graph graph;
  for (const SourceFile& file : files) {
    if (is_test_code(file.path)) continue;
    for (const std::string& include : quoted_includes(file.text)) {
      const std::string user = folder_of(file.path), used = folder_of(include);
      if (user != used) graph[user].insert(used);
    }
  }
  return graph;
}

/// The folders that are left when those without uses, or used by nobody left, are taken away again
/// and again: those on cycles, and between cycles.
std::set<std::string> folders_on_cycles(Graph graph) {
  for (bool changed = true; changed;) {
    changed = false;
    for (auto at = graph.begin(); at != graph.end();) {
      std::erase_if(at->second, [&](const std::string& used) { return !graph.contains(used); });
      changed |= at->second.empty();
      at = at->second.empty() ? graph.erase(at) : std::next(at);
    }
  }
  std::set<std::string> names;
  for (const auto& [name, used] : graph) names.insert(name);
  return names;
}

const std::vector<std::string> kFolders = {"roomcast", "web/wasm", "bench", "fuzz"};

TEST(Layering, every_include_follows_the_table) {
  const std::vector<SourceFile> files = read_cpp_files(ROOMCAST_SOURCE_DIR, kFolders);
  EXPECT_GT(files.size(), 10u);
  for (const SourceFile& file : files) EXPECT_THAT(forbidden_includes(file), testing::IsEmpty());
}

TEST(Layering, no_folders_include_each_other_at_any_depth) {
  const std::vector<SourceFile> files = read_cpp_files(ROOMCAST_SOURCE_DIR, {"roomcast"});
  for (int depth = 1; depth <= 4; ++depth) {
    EXPECT_THAT(folders_on_cycles(folder_graph(files, depth)), testing::IsEmpty()) << depth;
  }
}

TEST(Layering, the_table_uses_only_rows_above) {
  std::set<std::string> above;
  for (const Layer& layer : kLayers) {
    for (const std::string& used : words(layer.may_use)) {
      if (used == "*" || (layer.folder == "cli" && used == "bench")) continue;
      EXPECT_TRUE(above.contains(used)) << layer.folder << " -> " << used;
    }
    above.insert(std::string(layer.folder));
  }
}

TEST(Layering, the_table_names_only_folders_that_exist) {
  const std::filesystem::path root(ROOMCAST_SOURCE_DIR);
  for (const Layer& layer : kLayers) {
    const std::filesystem::path folder(layer.folder);
    EXPECT_TRUE(exists(root / "roomcast" / folder) || exists(root / folder)) << layer.folder;
  }
}

TEST(Layering, the_table_allows_nothing_that_is_not_used) {
  std::map<std::string, std::set<std::string>> used, used_by_tests;
  for (const SourceFile& file : read_cpp_files(ROOMCAST_SOURCE_DIR, {"roomcast"})) {
    auto& uses = is_test_code(file.path) ? used_by_tests : used;
    for (const std::string& include : quoted_includes(file.text)) {
      uses[layer_name(file.path)].insert(layer_name(include));
    }
  }
  for (const Layer& layer : kLayers) {
    if (!std::filesystem::exists(std::filesystem::path(ROOMCAST_SOURCE_DIR) / "roomcast" /
                                 layer.folder) ||
        layer.folder == "cli") {
      continue;
    }
    const std::string name(layer.folder);
    EXPECT_THAT(used[name], testing::IsSupersetOf(words(layer.may_use))) << name;
    EXPECT_THAT(used_by_tests[name], testing::IsSupersetOf(words(layer.tests_may_use))) << name;
  }
}

std::vector<std::string> includes_of_snippet(const std::string& path, const std::string& text) {
  return forbidden_includes({path, text});
}

TEST(Layering, finds_an_include_that_points_up) {
  EXPECT_THAT(includes_of_snippet("roomcast/codec/live/example.cpp",
                                  "#include <vector>\n#include \"roomcast/core/result.h\"\n"
                                  "  #  include \"roomcast/net/http_server.h\"\n"),
              testing::ElementsAre(testing::HasSubstr("codec/live may not use net")));
}

TEST(Layering, finds_an_include_of_the_folder_above) {
  EXPECT_THAT(includes_of_snippet("roomcast/render/blend/example.cpp",
                                  "#include \"roomcast/render/room_renderer.h\"\n"),
              testing::SizeIs(1));
}

TEST(Layering, finds_an_include_without_its_whole_path) {
  EXPECT_THAT(includes_of_snippet("roomcast/codec/example.h", "#include \"result.h\"\n"),
              testing::ElementsAre(testing::HasSubstr("not a path from the top of the tree")));
}

TEST(Layering, finds_a_folder_without_a_row) {
  EXPECT_THAT(includes_of_snippet("roomcast/misc/example.h", ""),
              testing::ElementsAre(testing::HasSubstr("no row in the table")));
}

TEST(Layering, lets_a_test_use_more_than_its_layer) {
  const std::string text = "#include \"roomcast/simulator/simulated_room.h\"\n";
  EXPECT_THAT(includes_of_snippet("roomcast/recording/measure/example_test.cpp", text),
              testing::IsEmpty());
  EXPECT_THAT(includes_of_snippet("roomcast/recording/measure/example.cpp", text),
              testing::SizeIs(1));
}

TEST(Layering, lets_no_folder_use_the_command_line) {
  EXPECT_THAT(
      includes_of_snippet("bench/align/example.cpp", "#include \"roomcast/cli/command.h\"\n"),
      testing::SizeIs(1));
}

TEST(Layering, finds_folders_that_include_each_other) {
  const std::vector<SourceFile> files = {
      {"roomcast/hub/room/a.h", "#include \"roomcast/hub/store/b.h\"\n"},
      {"roomcast/hub/store/b.h", "#include \"roomcast/hub/room/c.h\"\n"},
      {"roomcast/hub/room/c.h", "#include \"roomcast/core/d.h\"\n"}};
  EXPECT_THAT(folders_on_cycles(folder_graph(files, 1)), testing::IsEmpty());
  EXPECT_THAT(folders_on_cycles(folder_graph(files, 2)),
              testing::ElementsAre("roomcast/hub/room", "roomcast/hub/store"));
}

}  // namespace
}  // namespace roomcast::tests
