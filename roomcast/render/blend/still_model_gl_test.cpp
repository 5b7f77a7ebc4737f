// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/still_model.h"
#include "roomcast/render/room_fixture.h"

namespace roomcast::render {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

const CameraIntrinsics kStillLens = pinhole(64, 48, 60);
const RigidTransform kStillPose =
    world_from_optical_looking_at(Vector3d(0, 1.5, 0), Vector3d(0, 1.5, -2));
constexpr Rgb8 kModelColor = {40, 180, 90};

/// A square of 8 x 8 m at this z, which is seen from the origin, or from behind.
struct ModelWall {
  explicit ModelWall(float z_m, bool faces_us = true)
      : points_m{{-4, -4, z_m}, {4, -4, z_m}, {4, 4, z_m}, {-4, 4, z_m}} {
    triangles = {{0, 1, 2}, {0, 2, 3}};
    if (!faces_us) triangles = {{0, 2, 1}, {0, 3, 2}};
  }
  [[nodiscard]] ModelSurface surface() const { return {points_m, colors, triangles}; }

  std::vector<Vector3f> points_m;
  std::vector<Rgb8> colors = std::vector<Rgb8>(4, kModelColor);
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

class StillModelTest : public RoomTest {
 protected:
  Picture see(RenderMode mode) { return draw(eye_of(kStillLens, kStillPose), mode); }
  Rgb8 middle(RenderMode mode) { return see(mode).color.at(32, 24); }
  Status model(const ModelWall& wall, const ModelPlace& place = {0, 0, 0}) {
    return room_->set_model_piece(place, wall.surface());
  }
};

TEST_F(StillModelTest, alone_shows_no_sensor_and_without_a_piece_nothing) {
  add(kFirst, kStillLens, kStillPose, wall(kStillLens, 2000, kRed));
  EXPECT_EQ(middle(RenderMode::kStill), kNothing);
  ASSERT_TRUE(model(ModelWall(-3)).ok());
  const Picture still = see(RenderMode::kStill);
  EXPECT_EQ(still.color.at(32, 24), kModelColor);
  EXPECT_EQ(still.sensors.at(32, 24), kDrawnByNoSensor);
  ASSERT_TRUE(room_->set_model_piece({0, 0, 0}, {}).ok());
  EXPECT_EQ(middle(RenderMode::kStill), kNothing);
}

TEST_F(StillModelTest, fills_what_no_sensor_shows_and_covers_nothing) {
  SensorPictures pictures = wall(kStillLens, 2000, kRed);
  fill_box<std::uint16_t>(pictures.depth_mm, 40, 0, 64, 48, 0);
  add(kFirst, kStillLens, kStillPose, pictures);
  ASSERT_TRUE(model(ModelWall(-1)).ok()) << "before the sensor's wall";
  const Picture blend = see(RenderMode::kBlend);
  EXPECT_EQ(blend.color.at(20, 24), kRed);
  EXPECT_EQ(blend.color.at(55, 24), kModelColor);
  EXPECT_EQ(see(RenderMode::kMesh).color.at(55, 24), kNothing) << "other modes show sensors only";
  room_->clear_model();
  EXPECT_EQ(see(RenderMode::kBlend).color.at(55, 24), kNothing);
}

TEST_F(StillModelTest, the_nearer_piece_hides_the_other_and_backs_are_not_drawn) {
  ModelWall far(-3), near(-2);
  far.colors.assign(4, kBlue);
  ASSERT_TRUE(model(far, {0, 0, -1}).ok());
  EXPECT_EQ(middle(RenderMode::kStill), kBlue);
  ASSERT_TRUE(model(ModelWall(-2, false)).ok());
  EXPECT_EQ(middle(RenderMode::kStill), kBlue);
  ASSERT_TRUE(model(near).ok());
  EXPECT_EQ(middle(RenderMode::kStill), kModelColor);
}

TEST_F(StillModelTest, has_a_depth_and_is_drawn_for_each_eye) {
  ASSERT_TRUE(model(ModelWall(-3)).ok());
  const ViewCamera ahead = eye_of(kStillLens, kStillPose);
  ViewCamera back = ahead;
  back.world_from_view =
      world_from_optical_looking_at(Vector3d(0, 1.5, 0), Vector3d(0, 1.5, 2)) * optical_from_view();
  auto target = OffscreenTarget::create(ahead.width, ahead.height, 2);
  ASSERT_TRUE(target.ok());
  ASSERT_TRUE(room_->draw(Eyes(back, ahead), *target, RenderMode::kStill).ok());
  EXPECT_EQ(target->read_color(0).at(32, 24), kNothing) << "the piece is behind this eye";
  EXPECT_EQ(target->read_color(1).at(32, 24), kModelColor);
  EXPECT_NEAR(target->read_depth_m(ahead, 1).at(32, 24), 3, 0.01);
}

/// A wall of squares of 2.5 cm, as the hub's model has them.
ModelWall fine_wall(float z_m) {
  constexpr std::uint32_t kColumns = 160, kRows = 120;
  constexpr float kStep_m = 0.025F;
  ModelWall wall(z_m);
  wall.points_m.clear();
  wall.triangles.clear();
  for (std::uint32_t i = 0; i < kColumns * kRows; ++i) {
    const std::uint32_t x = i % kColumns, y = i / kColumns;
    wall.points_m.emplace_back(kStep_m * static_cast<float>(x) - 2, kStep_m * static_cast<float>(y),
                               z_m);
    if (x == 0 || y == 0) continue;
    wall.triangles.push_back({i - kColumns - 1, i - kColumns, i});
    wall.triangles.push_back({i - kColumns - 1, i, i - 1});
  }
  wall.colors.assign(wall.points_m.size(), kModelColor);
  return wall;
}

TEST_F(StillModelTest, fills_every_hole_however_small) {
  SensorPictures pictures = wall(kStillLens, 2000, kRed);
  fill_box<std::uint16_t>(pictures.depth_mm, 2, 3, 6, 7, 0);
  fill_box<std::uint16_t>(pictures.depth_mm, 17, 30, 22, 34, 0);
  fill_box<std::uint16_t>(pictures.depth_mm, 40, 12, 54, 25, 0);
  add(kFirst, kStillLens, kStillPose, pictures);
  const Picture without = see(RenderMode::kBlend);
  ASSERT_TRUE(model(fine_wall(-2.2F)).ok());
  const Picture with = see(RenderMode::kBlend);
  int holes = 0;
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool is_hole = without.color.at(x, y) == kNothing;
      holes += is_hole;
      EXPECT_EQ(with.color.at(x, y), is_hole ? kModelColor : without.color.at(x, y))
          << "at " << x << ", " << y;
    }
  }
  EXPECT_GT(holes, 150);
}

TEST_F(StillModelTest, a_piece_that_lacks_something_is_refused) {
  ModelWall colorless(-3), wild(-3);
  colorless.colors.pop_back();
  wild.triangles[0][1] = 4;
  EXPECT_EQ(model(colorless).error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(model(wild).error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(middle(RenderMode::kStill), kNothing);
}

}  // namespace
}  // namespace roomcast::render
