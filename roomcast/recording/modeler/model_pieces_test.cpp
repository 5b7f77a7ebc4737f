// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/modeler/model_pieces.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/model/pieces/draco_mesh.h"
#include "roomcast/model/pieces/model_message.h"

namespace roomcast::recording {
namespace {

using testing::UnorderedElementsAre;

/// A square floor of points every 5 cm, from x = `from_m` on, 1 m wide.
model::RoomMesh floor_at(float from_m, Rgb8 color = {100, 100, 100}) {
  constexpr std::uint32_t kSide = 21;
  model::RoomMesh mesh;
  for (std::uint32_t row = 0; row < kSide; ++row) {
    for (std::uint32_t column = 0; column < kSide; ++column) {
      mesh.points_m.emplace_back(from_m + 0.05F * static_cast<float>(column), 0.025F,
                                 0.05F * static_cast<float>(row) + 0.02F);
      mesh.colors.push_back(color);
    }
  }
  for (std::uint32_t row = 0; row + 1 < kSide; ++row) {
    for (std::uint32_t column = 0; column + 1 < kSide; ++column) {
      const std::uint32_t corner = row * kSide + column;
      mesh.triangles.push_back({corner, corner + kSide, corner + 1});
      mesh.triangles.push_back({corner + 1, corner + kSide, corner + kSide + 1});
    }
  }
  return mesh;
}

model::RoomMesh both(model::RoomMesh a, const model::RoomMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.points_m.size());
  a.points_m.insert(a.points_m.end(), b.points_m.begin(), b.points_m.end());
  a.colors.insert(a.colors.end(), b.colors.begin(), b.colors.end());
  for (auto triangle : b.triangles) {
    for (std::uint32_t& point : triangle) point += offset;
    a.triangles.push_back(triangle);
  }
  return a;
}

model::ModelMessage parsed(const std::string& bytes) {
  const auto message = model::read_model_message(
      std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
  EXPECT_TRUE(message.ok()) << message.error().message;
  return *message;
}

std::vector<std::int32_t> places(const model::ModelMessage& message) {
  std::vector<std::int32_t> x;
  for (const auto& piece : message.pieces) x.push_back(piece.place.x);
  return x;
}

TEST(ModelPieces, a_mesh_is_cut_and_no_triangle_is_lost) {
  const auto mesh = both(floor_at(1.52F), floor_at(6));
  const auto parts = cut_mesh(mesh, 2);
  ASSERT_EQ(parts.size(), 3u);
  std::size_t triangles = 0;
  for (const auto& [place, part] : parts) {
    triangles += part.triangles.size();
    EXPECT_EQ(part.points_m.size(), part.colors.size());
    for (const auto& triangle : part.triangles) {
      for (const std::uint32_t point : triangle) ASSERT_LT(point, part.points_m.size());
    }
  }
  EXPECT_EQ(triangles, mesh.triangles.size());
}

TEST(ModelPieces, the_first_answer_is_whole_and_the_next_one_has_what_is_new) {
  ModelPieces pieces;
  EXPECT_TRUE(pieces.update(both(floor_at(0.5F), floor_at(4.5F)), 100));
  const std::string first = pieces.changes_after(0);
  EXPECT_TRUE(parsed(first).is_whole);
  EXPECT_EQ(parsed(first).version, 100u);
  EXPECT_THAT(places(parsed(first)), UnorderedElementsAre(0, 2));

  EXPECT_TRUE(pieces.update(both(floor_at(0.5F), floor_at(4.8F)), 200));
  const std::string next = pieces.changes_after(100);
  EXPECT_FALSE(parsed(next).is_whole);
  EXPECT_THAT(places(parsed(next)), UnorderedElementsAre(2));
  EXPECT_EQ(pieces.version(), 200u);
}

TEST(ModelPieces, a_mesh_that_looks_the_same_changes_nothing) {
  ModelPieces pieces;
  EXPECT_TRUE(pieces.update(floor_at(0.5F), 100));
  model::RoomMesh again = floor_at(0.5F, Rgb8{102, 101, 100});
  for (auto& point_m : again.points_m) point_m.y() += 0.004F;
  EXPECT_FALSE(pieces.update(again, 200));
  EXPECT_EQ(pieces.version(), 100u);
  EXPECT_TRUE(pieces.update(floor_at(0.5F, Rgb8{20, 20, 20}), 300)) << "the light was switched off";
}

model::RoomMesh raised(model::RoomMesh mesh, float by_m) {
  for (auto& point_m : mesh.points_m) point_m.y() += by_m;
  return mesh;
}

/// The first `side` rows of as many points, as of a thing's top.
model::RoomMesh top_at(float height_m, std::uint32_t side = 7) {
  model::RoomMesh top = raised(floor_at(0.5F), height_m);
  std::erase_if(top.triangles, [&](const auto& triangle) {
    return std::ranges::any_of(
        triangle, [&](std::uint32_t point) { return point / 21 >= side || point % 21 >= side; });
  });
  return top;
}

TEST(ModelPieces, a_small_thing_that_goes_from_a_piece_full_of_others_is_a_change) {
  model::RoomMesh shelves = floor_at(0.5F);
  for (int i = 1; i < 6; ++i)
    shelves = both(shelves, raised(floor_at(0.5F), 0.2F * static_cast<float>(i)));
  ModelPieces pieces;
  EXPECT_TRUE(pieces.update(both(shelves, top_at(1.7F)), 100));
  EXPECT_FALSE(pieces.update(both(shelves, top_at(1.75F)), 200)) << "nearly where it was";
  EXPECT_TRUE(pieces.update(shelves, 300));
}

TEST(ModelPieces, what_is_left_of_a_thing_that_has_just_gone_is_a_change_noise_is_none) {
  const model::RoomMesh floor = floor_at(0.5F);
  const auto part_of_top = [&](std::uint32_t side) {
    const auto cut = cut_mesh(top_at(1.2F, side), kPieceEdge_m);  // without unused points
    return both(floor, cut.begin()->second);
  };
  ModelPieces pieces;
  EXPECT_TRUE(pieces.update(part_of_top(9), 100));
  EXPECT_TRUE(pieces.update(part_of_top(4), 200));
  EXPECT_TRUE(pieces.update(floor, 300)) << "16 cubes are left";
  EXPECT_FALSE(pieces.update(floor, 400));
  EXPECT_FALSE(pieces.update(part_of_top(2), 500)) << "nothing has changed here for a while";
}

TEST(ModelPieces, a_piece_that_goes_is_named_with_nothing_in_it) {
  ModelPieces pieces;
  EXPECT_TRUE(pieces.update(both(floor_at(0.5F), floor_at(4.5F)), 100));
  EXPECT_TRUE(pieces.update(floor_at(0.5F), 200));
  const std::string next = pieces.changes_after(150);
  const model::ModelMessage change = parsed(next);
  ASSERT_EQ(change.pieces.size(), 1u);
  EXPECT_EQ(change.pieces[0].place.x, 2);
  EXPECT_TRUE(change.pieces[0].draco.empty());
  EXPECT_FALSE(pieces.update(floor_at(0.5F), 300)) << "it has gone already";
  const std::string whole = pieces.changes_after(0);
  EXPECT_THAT(places(parsed(whole)), UnorderedElementsAre(0));
}

TEST(ModelPieces, who_has_the_model_of_an_earlier_run_is_told_to_forget_it) {
  ModelPieces pieces;
  EXPECT_TRUE(pieces.update(floor_at(0.5F), 100));
  EXPECT_TRUE(parsed(pieces.changes_after(99)).is_whole);
  EXPECT_FALSE(parsed(pieces.changes_after(100)).is_whole);
}

TEST(ModelPieces, pieces_can_be_decoded) {
  ModelPieces pieces;
  const auto mesh = floor_at(0.5F);
  EXPECT_TRUE(pieces.update(mesh, 100));
  const std::string bytes = pieces.changes_after(0);
  const auto decoded = model::decode_draco(parsed(bytes).pieces.at(0).draco);
  ASSERT_TRUE(decoded.ok());
  EXPECT_EQ(decoded->triangles.size(), mesh.triangles.size());
}

}  // namespace
}  // namespace roomcast::recording
