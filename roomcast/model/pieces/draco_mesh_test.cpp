// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/pieces/draco_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

namespace roomcast::model {
namespace {

/// A wavy floor of 4 x 4 m in cells of 2 cm, every point of another colour.
RoomMesh floor_mesh() {
  constexpr std::uint32_t kSide = 200;
  RoomMesh mesh;
  for (std::uint32_t z = 0; z < kSide; ++z) {
    for (std::uint32_t x = 0; x < kSide; ++x) {
      const float height = 0.05F * std::sin(0.1F * static_cast<float>(x + z));
      mesh.points_m.emplace_back(0.02F * static_cast<float>(x), height,
                                 0.02F * static_cast<float>(z));
      mesh.colors.push_back({static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(z), 9});
    }
  }
  for (std::uint32_t z = 0; z + 1 < kSide; ++z) {
    for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
      const std::uint32_t at = z * kSide + x;
      mesh.triangles.push_back({at, at + kSide, at + 1});
      mesh.triangles.push_back({at + 1, at + kSide, at + kSide + 1});
    }
  }
  return mesh;
}

TEST(DracoMesh, points_move_by_less_than_a_step_and_colors_by_little) {
  const RoomMesh mesh = floor_mesh();
  const auto coded = encode_draco(mesh);
  ASSERT_TRUE(coded.ok()) << coded.error().message;
  EXPECT_EQ(coded->triangles, mesh.triangles.size());
  const auto back = decode_draco(coded->bytes);
  ASSERT_TRUE(back.ok()) << back.error().message;
  ASSERT_EQ(back->points_m.size(), coded->points);
  ASSERT_EQ(back->triangles.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < back->points_m.size(); ++i) {
    const Eigen::Vector3f& at = back->points_m[i];
    const auto x = static_cast<std::size_t>(std::lround(at.x() / 0.02F));
    const auto z = static_cast<std::size_t>(std::lround(at.z() / 0.02F));
    const std::size_t same = 200 * z + x;
    ASSERT_LT(same, mesh.points_m.size());
    EXPECT_LT((at - mesh.points_m[same]).norm(), kDracoStep_m);
    const Rgb8 is = back->colors[i], was = mesh.colors[same];
    EXPECT_LE(std::max({std::abs(is.r - was.r), std::abs(is.g - was.g), std::abs(is.b - was.b)}),
              3);
  }
}

TEST(DracoMesh, takes_a_fraction_of_the_bytes) {
  const RoomMesh mesh = floor_mesh();
  const auto coded = encode_draco(mesh);
  ASSERT_TRUE(coded.ok());
  const std::size_t plain = 20 * mesh.points_m.size() + 12 * mesh.triangles.size();
  EXPECT_LT(coded->bytes.size(), plain / 8);
}

TEST(DracoMesh, a_mesh_without_an_area_or_of_a_whole_town_is_refused) {
  RoomMesh flat;
  flat.points_m = {{0, 0, 0}, {1, 0, 0}};
  flat.colors.resize(2);
  flat.triangles = {{0, 1, 1}};
  EXPECT_FALSE(encode_draco(flat).ok());
  RoomMesh town = floor_mesh();
  town.points_m.front().x() = 5'000;
  const auto coded = encode_draco(town);
  ASSERT_FALSE(coded.ok());
  EXPECT_EQ(coded.error().code, ErrorCode::kInvalidArgument);
}

TEST(DracoMesh, damaged_bytes_are_no_mesh_or_another_one) {
  const auto coded = encode_draco(floor_mesh());
  ASSERT_TRUE(coded.ok());
  EXPECT_FALSE(decode_draco({}).ok());
  EXPECT_FALSE(decode_draco(std::span(coded->bytes).first(coded->bytes.size() / 2)).ok());
}

}  // namespace
}  // namespace roomcast::model
