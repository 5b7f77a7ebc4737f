// SPDX-License-Identifier: Apache-2.0
// Who may include whom. Arrows point down: a layer uses only layers above it in this table, so
// there are no cycles.
#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/source_tree.h"

namespace roomcast::tests {
namespace {

/// A folder of the tree, or one header of a folder where others may use no more than that.
struct Layer {
  std::string_view path;
  std::vector<std::string_view> may_use;
};

// clang-format off
const std::vector<Layer> kLayers = {
    {"roomcast/core",                    {}},
    {"roomcast/geometry",                {"roomcast/core"}},
    {"roomcast/codec",                   {"roomcast/core"}},
    {"roomcast/wire",                    {"roomcast/core"}},
    {"roomcast/room",                    {"roomcast/core", "roomcast/geometry", "roomcast/codec", "roomcast/wire"}},
    {"roomcast/recording/mcap",          {"roomcast/core"}},
    {"roomcast/recording",               {"roomcast/core", "roomcast/geometry", "roomcast/codec", "roomcast/wire",
                                          "roomcast/room", "roomcast/recording/mcap"}},
    {"roomcast/net",                     {"roomcast/core"}},
    {"roomcast/source/frame_source.h",   {"roomcast/core", "roomcast/geometry"}},
    {"roomcast/source/camera",           {"roomcast/core", "roomcast/geometry", "roomcast/source/frame_source.h"}},
    {"roomcast/source/freenect",         {"roomcast/core", "roomcast/geometry", "roomcast/source/frame_source.h",
                                          "roomcast/source/camera"}},
    {"roomcast/source/openni2",          {"roomcast/core", "roomcast/geometry", "roomcast/source/frame_source.h",
                                          "roomcast/source/camera"}},
    {"roomcast/source/realsense",        {"roomcast/core", "roomcast/geometry", "roomcast/source/frame_source.h",
                                          "roomcast/source/camera"}},
    {"roomcast/source/freenect2",        {"roomcast/core", "roomcast/geometry", "roomcast/source/frame_source.h",
                                          "roomcast/source/camera"}},
    {"roomcast/source/k4a",              {"roomcast/core", "roomcast/geometry", "roomcast/source/frame_source.h",
                                          "roomcast/source/camera"}},
    {"roomcast/sensor/source_factory.h", {"roomcast/core", "roomcast/source/frame_source.h",
                                          "roomcast/source/camera"}},
    {"roomcast/source/simulator",        {"roomcast/core", "roomcast/geometry", "roomcast/source/frame_source.h",
                                          "roomcast/sensor/source_factory.h"}},
    {"roomcast/source/replay",           {"roomcast/core", "roomcast/geometry", "roomcast/codec", "roomcast/wire",
                                          "roomcast/room", "roomcast/recording", "roomcast/recording/mcap",
                                          "roomcast/source/frame_source.h", "roomcast/sensor/source_factory.h"}},
    {"roomcast/source",                  {"roomcast/core", "roomcast/geometry", "roomcast/source/frame_source.h",
                                          "roomcast/sensor/source_factory.h", "roomcast/source/simulator", "roomcast/source/replay",
                                          "roomcast/source/camera", "roomcast/source/freenect",
                                          "roomcast/source/openni2", "roomcast/source/realsense",
                                          "roomcast/source/freenect2", "roomcast/source/k4a"}},
    {"roomcast/frame_sets",              {"roomcast/core", "roomcast/geometry", "roomcast/codec", "roomcast/wire",
                                          "roomcast/room", "roomcast/recording", "roomcast/recording/mcap",
                                          "roomcast/source", "roomcast/sensor/source_factory.h"}},
    {"roomcast/export",                  {"roomcast/core", "roomcast/geometry", "roomcast/codec",
                                          "roomcast/recording/mcap", "roomcast/source", "roomcast/frame_sets"}},
    {"roomcast/align",                   {"roomcast/core", "roomcast/geometry"}},
    {"roomcast/measure",                 {"roomcast/core", "roomcast/geometry", "roomcast/codec", "roomcast/frame_sets",
                                          "roomcast/export", "roomcast/align"}},
    {"roomcast/recording/measure/simulated_rooms_test.cpp",
                                         {"roomcast/core", "roomcast/geometry", "roomcast/align", "roomcast/measure",
                                          "roomcast/source/simulator"}},
    {"roomcast/calibration",             {"roomcast/core", "roomcast/geometry", "roomcast/source/frame_source.h",
                                          "roomcast/source", "roomcast/align"}},
    {"roomcast/render",                  {"roomcast/core", "roomcast/geometry"}},
    {"roomcast/hub",                     {"roomcast/core", "roomcast/wire", "roomcast/net"}},
    {"roomcast/client",                  {"roomcast/core", "roomcast/geometry", "roomcast/codec", "roomcast/wire",
                                          "roomcast/room", "roomcast/net"}},
    {"roomcast/mirror",                  {"roomcast/core", "roomcast/wire", "roomcast/room", "roomcast/net", "roomcast/hub"}},
    {"roomcast/upstream",                {"roomcast/core", "roomcast/wire", "roomcast/room", "roomcast/net", "roomcast/hub",
                                          "roomcast/client", "roomcast/mirror"}},
    {"roomcast/cluster",                 {"roomcast/core", "roomcast/wire", "roomcast/room", "roomcast/net", "roomcast/hub",
                                          "roomcast/client", "roomcast/mirror"}},
    {"roomcast/recorder",                {"roomcast/core", "roomcast/geometry", "roomcast/codec", "roomcast/wire",
                                          "roomcast/room", "roomcast/net", "roomcast/client", "roomcast/recording",
                                          "roomcast/recording/mcap"}},
    {"roomcast/capi",                    {"roomcast/core", "roomcast/geometry", "roomcast/codec", "roomcast/room",
                                          "roomcast/client", "roomcast/recorder"}},
    {"roomcast/aligner",                 {"roomcast/core", "roomcast/geometry", "roomcast/codec", "roomcast/wire",
                                          "roomcast/room", "roomcast/net", "roomcast/source", "roomcast/source/frame_source.h",
                                          "roomcast/sensor/source_factory.h", "roomcast/align", "roomcast/client"}},
    {"roomcast/alignment/service/room_aligner_test.cpp",
                                         {"roomcast/core", "roomcast/geometry", "roomcast/align", "roomcast/client",
                                          "roomcast/aligner", "roomcast/hub"}},
    {"roomcast/viewer",                  {"roomcast/core", "roomcast/geometry", "roomcast/render", "roomcast/room", "roomcast/client"}},
    {"roomcast/film",                    {"roomcast/core", "roomcast/geometry", "roomcast/codec", "roomcast/source",
                                          "roomcast/frame_sets", "roomcast/export", "roomcast/render", "roomcast/viewer"}},
    {"web/wasm",                         {"roomcast/core", "roomcast/codec"}},
    {"bench",                            {"roomcast"}},
    {"fuzz",                             {"roomcast/core", "roomcast/geometry", "roomcast/codec", "roomcast/wire",
                                          "roomcast/net", "roomcast/recording", "roomcast/recording/mcap", "roomcast/cluster"}},
    {"roomcast/cli",                     {"roomcast", "bench"}},
};
// clang-format on

bool is_under(std::string_view path, std::string_view folder) {
  return path.substr(0, folder.size()) == folder &&
         (path.size() == folder.size() || path[folder.size()] == '/');
}

/// The longest entry of the table that holds `path`.
const Layer* layer_of(std::string_view path) {
  const Layer* found = nullptr;
  for (const Layer& layer : kLayers) {
    if (is_under(path, layer.path) && (!found || layer.path.size() > found->path.size())) {
      found = &layer;
    }
  }
  return found;
}

bool may_use(const Layer& user, const Layer& used) {
  if (&user == &used) return true;
  return std::any_of(user.may_use.begin(), user.may_use.end(), [&](std::string_view allowed) {
    return allowed == used.path || (allowed == "roomcast" && is_under(used.path, "roomcast") &&
                                    used.path != "roomcast/cli");
  });
}

/// One sentence for each include of `file` that the table does not allow.
std::vector<std::string> forbidden_arrows(const SourceFile& file) {
  const Layer* user = layer_of(file.path.string());
  if (!user) return {file.path.string() + " lies in a folder that has no row in the table"};
  std::vector<std::string> sentences;
  for (const std::string& include : quoted_includes(file.text)) {
    const Layer* used = layer_of(include);
    if (!used) {
      sentences.push_back(file.path.string() + " includes \"" + include +
                          "\", which is not a path from the top of the tree into a known folder");
    } else if (!may_use(*user, *used)) {
      sentences.push_back(file.path.string() + " includes \"" + include + "\", but " +
                          std::string(user->path) + " may not use " + std::string(used->path));
    }
  }
  return sentences;
}

const std::vector<std::string> kFolders = {"roomcast", "web/wasm", "bench", "fuzz"};

TEST(Layering, every_include_follows_the_table) {
  const std::vector<SourceFile> files = read_cpp_files(ROOMCAST_SOURCE_DIR, kFolders);
  EXPECT_GT(files.size(), 10u);
  for (const SourceFile& file : files) EXPECT_THAT(forbidden_arrows(file), testing::IsEmpty());
}

TEST(Layering, table_has_no_arrow_up) {
  for (std::size_t row = 0; row < kLayers.size(); ++row) {
    for (const std::string_view allowed : kLayers[row].may_use) {
      if (allowed == "roomcast") continue;  // all of it but the command line
      const bool is_above =
          std::any_of(kLayers.begin(), kLayers.begin() + static_cast<std::ptrdiff_t>(row),
                      [&](const Layer& layer) { return layer.path == allowed; });
      EXPECT_TRUE(is_above) << kLayers[row].path << " -> " << allowed;
    }
  }
}

TEST(Layering, table_names_only_what_exists) {
  for (const Layer& layer : kLayers) {
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(ROOMCAST_SOURCE_DIR) / layer.path))
        << layer.path;
  }
}

std::vector<std::string> arrows_of_snippet(const std::string& path, const std::string& text) {
  return forbidden_arrows({path, text});
}

TEST(Layering, finds_an_arrow_that_points_up) {
  EXPECT_THAT(arrows_of_snippet("roomcast/codec/example.cpp",
                                "#include <vector>\n#include \"roomcast/core/result.h\"\n"
                                "  #  include \"roomcast/net/http_server.h\"\n"),
              testing::ElementsAre(testing::HasSubstr("roomcast/codec may not use roomcast/net")));
}

TEST(Layering, finds_an_include_without_its_whole_path) {
  EXPECT_THAT(arrows_of_snippet("roomcast/codec/example.h", "#include \"result.h\"\n"),
              testing::ElementsAre(testing::HasSubstr("not a path from the top of the tree")));
}

TEST(Layering, finds_a_folder_without_a_row) {
  EXPECT_THAT(arrows_of_snippet("roomcast/misc/example.h", ""),
              testing::ElementsAre(testing::HasSubstr("no row in the table")));
}

TEST(Layering, lets_the_simulator_see_the_interface_of_sources_but_not_other_sources) {
  EXPECT_THAT(arrows_of_snippet("roomcast/source/simulator/provisional.h",
                                "#include \"roomcast/source/frame_source.h\"\n"),
              testing::IsEmpty());
  EXPECT_THAT(arrows_of_snippet("roomcast/source/simulator/provisional.h",
                                "#include \"roomcast/source/rig/rig_source.h\"\n"),
              testing::SizeIs(1));
}

TEST(Layering, lets_nobody_use_the_command_line) {
  EXPECT_THAT(arrows_of_snippet("bench/provisional.cpp", "#include \"roomcast/cli/demo.h\"\n"),
              testing::SizeIs(1));
}

}  // namespace
}  // namespace roomcast::tests
