// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mesh/mesh_files.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/core/little_endian.h"

namespace roomcast::recording {
namespace {

model::RoomMesh square() {
  model::RoomMesh mesh;
  mesh.points_m = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, -2}};
  mesh.colors = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {128, 128, 128}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

std::vector<std::uint8_t> encoded(MeshFile file) {
  std::vector<std::uint8_t> bytes;
  const Status status = append_mesh(square(), file, bytes);
  EXPECT_TRUE(status.ok()) << status.error().message;
  return bytes;
}

TEST(MeshFiles, glb_has_the_points_the_colors_and_the_triangles) {
  const auto bytes = encoded(MeshFile::kGlb);
  ASSERT_GT(bytes.size(), 20u);
  EXPECT_EQ(read_u32(&bytes[8]), bytes.size());
  const std::uint32_t json_bytes = read_u32(&bytes[12]);
  const auto root = nlohmann::json::parse(bytes.begin() + 20, bytes.begin() + 20 + json_bytes);
  const auto& primitive = root["meshes"][0]["primitives"][0];
  const auto& accessors = root["accessors"];
  const auto accessor = [&](const char* name) {
    return accessors[primitive["attributes"][name].get<std::size_t>()];
  };
  EXPECT_EQ(accessor("POSITION")["count"], 4);
  EXPECT_EQ(accessor("POSITION")["min"], nlohmann::json({0.0, 0.0, -2.0}));
  EXPECT_EQ(accessor("NORMAL")["count"], 4);
  EXPECT_EQ(accessor("COLOR_0")["normalized"], true);
  EXPECT_EQ(accessors[primitive["indices"].get<std::size_t>()]["count"], 6);
  const auto& color_view =
      root["bufferViews"][accessor("COLOR_0")["bufferView"].get<std::size_t>()];
  const std::uint8_t* colors =
      &bytes[20 + json_bytes + 8 + color_view["byteOffset"].get<std::size_t>()];
  EXPECT_EQ(read_u16(colors), 65535);
  EXPECT_EQ(read_u16(colors + 2), 0);
  EXPECT_NEAR(read_u16(colors + 24), 65535 * 0.2159, 10);  // grey, in linear light
  EXPECT_EQ(root["nodes"][0]["mesh"], 0);
}

TEST(MeshFiles, ply_has_as_many_bytes_as_its_header_says) {
  const auto bytes = encoded(MeshFile::kPly);
  const std::string text(bytes.begin(), bytes.end());
  EXPECT_NE(text.find("element vertex 4\n"), std::string::npos);
  EXPECT_NE(text.find("element face 2\n"), std::string::npos);
  const std::string end = "end_header\n";
  EXPECT_EQ(bytes.size(), text.find(end) + end.size() + 4 * 27 + 2 * 13);
}

TEST(MeshFiles, obj_counts_points_from_one) {
  const auto bytes = encoded(MeshFile::kObj);
  const std::string text(bytes.begin(), bytes.end());
  EXPECT_NE(text.find("v 1.0000 0.0000 0.0000 0.000 1.000 0.000\n"), std::string::npos);
  EXPECT_NE(text.find("f 1//1 2//2 3//3\nf 1//1 3//3 4//4\n"), std::string::npos);
  EXPECT_EQ(std::ranges::count(text, '\n'), 2 + 4 + 4 + 2);
}

}  // namespace
}  // namespace roomcast::recording
