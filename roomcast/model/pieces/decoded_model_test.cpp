// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/pieces/decoded_model.h"

#include <string>

#include <gtest/gtest.h>

#include "roomcast/model/pieces/draco_mesh.h"
#include "roomcast/model/pieces/model_message.h"

namespace roomcast::model {
namespace {

RoomMesh triangle() {
  RoomMesh mesh;
  mesh.points_m = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  mesh.colors.assign(3, {200, 100, 50});
  mesh.triangles = {{0, 2, 1}};
  return mesh;
}

Result<DecodedModel> decoded(const std::string& bytes) {
  return decode_model({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

TEST(DecodedModel, has_the_pieces_and_those_that_have_gone) {
  const DracoMesh coded = encode_draco(triangle()).value();
  const auto model = decoded(write_model_message(
      {.is_whole = false, .version = 7, .pieces = {{{0, 0, 0}, coded.bytes}, {{3, 0, 0}, {}}}}));
  ASSERT_TRUE(model.ok());
  EXPECT_FALSE(model->is_whole);
  EXPECT_EQ(model->version, 7u);
  ASSERT_EQ(model->pieces.size(), 2u);
  EXPECT_EQ(model->pieces[0].mesh.triangles.size(), 1u);
  EXPECT_EQ(model->pieces[1].place, (GridPlace{3, 0, 0}));
  EXPECT_TRUE(model->pieces[1].mesh.triangles.empty());
}

TEST(DecodedModel, a_damaged_piece_is_refused) {
  const std::vector<std::uint8_t> damaged(20, 1);
  EXPECT_FALSE(decoded(write_model_message({.version = 7, .pieces = {{{0, 0, 0}, damaged}}})).ok());
  EXPECT_FALSE(decoded("no model").ok());
}

}  // namespace
}  // namespace roomcast::model
