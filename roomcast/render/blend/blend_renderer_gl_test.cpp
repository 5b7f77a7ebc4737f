// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/blend_renderer.h"
#include "roomcast/render/room_fixture.h"

namespace roomcast::render {
namespace {

using Eigen::Vector3d;

const CameraIntrinsics kBlendRendererLens = pinhole(64, 48, 60);
const CameraIntrinsics kWideLens = pinhole(192, 144, 60);
const Vector3d kBlendRendererEye(0, 1.5, 0), kBlendRendererAhead(0, 1.5, -2);
const RigidTransform kBlendRendererPose =
    world_from_optical_looking_at(kBlendRendererEye, kBlendRendererAhead);

class BlendTest : public RoomTest {
 protected:
  Rgb8 middle_from(const Vector3d& eye) {
    const RigidTransform pose = world_from_optical_looking_at(eye, kBlendRendererAhead);
    return draw(eye_of(kBlendRendererLens, pose), RenderMode::kBlend).color.at(32, 24);
  }
  void see(Unseen unseen) {
    options_.unseen = unseen;
    ASSERT_TRUE(room_->set_options(options_).ok());
  }
};

TEST_F(BlendTest, who_sees_a_surface_as_the_eye_does_counts_more) {
  // Both sensors see the same spot from 2 m.
  const RigidTransform aside = world_from_optical_looking_at(
      kBlendRendererAhead + Vector3d(1.6, 0, 1.2), kBlendRendererAhead);
  SensorPictures green = wall(kBlendRendererLens, 2000, {120, 200, 120});
  add(kFirst, kBlendRendererLens, kBlendRendererPose,
      wall(kBlendRendererLens, 2000, {200, 120, 120}));
  add(kSecond, kBlendRendererLens, aside, green);
  const Rgb8 from_first = middle_from(kBlendRendererEye);
  const Rgb8 from_second = middle_from(kBlendRendererAhead + Vector3d(1.6, 0, 1.2));
  EXPECT_GT(from_first.r, from_first.g);
  EXPECT_GT(from_second.g, from_second.r);
}

TEST_F(BlendTest, surfaces_two_centimetres_apart_are_mixed_and_half_a_metre_apart_are_not) {
  add(kFirst, kBlendRendererLens, kBlendRendererPose,
      wall(kBlendRendererLens, 2000, {200, 100, 100}));
  add(kSecond, kBlendRendererLens, kBlendRendererPose,
      wall(kBlendRendererLens, 2500, {100, 100, 200}));
  EXPECT_EQ(middle_from(kBlendRendererEye), (Rgb8{200, 100, 100}));
  add(kSecond, kBlendRendererLens, kBlendRendererPose,
      wall(kBlendRendererLens, 2020, {100, 100, 200}));
  const Rgb8 mixed = middle_from(kBlendRendererEye);
  EXPECT_GT(mixed.r, 120);
  EXPECT_GT(mixed.b, 120);
}

TEST_F(BlendTest, colours_twice_as_fine_as_depth_are_drawn_as_fine) {
  SensorPictures pictures = wall(kBlendRendererLens, 2000, kRed);
  pictures.color = ColorImage(2 * kBlendRendererLens.width, 2 * kBlendRendererLens.height, kRed);
  for (int x = 0; x < pictures.color.width(); x += 2) {  // stripes finer than a depth pixel
    fill_box(pictures.color, x, 0, x + 1, pictures.color.height(), kBlue);
  }
  add(kFirst, kBlendRendererLens, kBlendRendererPose, pictures);
  const ColorImage drawn =
      draw(eye_of(pinhole(128, 96, 120), kBlendRendererPose), RenderMode::kBlend).color;
  for (int x = 40; x < 80; ++x) {
    const Rgb8 color = drawn.at(x, 48);
    EXPECT_EQ(color.b > color.r, x % 2 == 0) << x;
  }
}

TEST_F(BlendTest, a_hole_takes_the_colour_around_it_and_the_outside_does_not) {
  SensorPictures pictures = wall(kBlendRendererLens, 2000, kRed);
  fill_box<std::uint16_t>(pictures.depth_mm, 26, 18, 38, 30, 0);
  add(kFirst, kBlendRendererLens, kBlendRendererPose, pictures);
  const auto wide = [&] { return draw(eye_of(kWideLens, kBlendRendererPose), RenderMode::kBlend); };
  const int middle_x = 96, middle_y = 72;
  EXPECT_EQ(wide().color.at(middle_x, middle_y), kNothing);
  see(Unseen::kHolesFilled);
  const Picture filled = wide();
  EXPECT_EQ(filled.color.at(middle_x, middle_y), kRed);
  EXPECT_EQ(filled.sensors.at(middle_x, middle_y), kDrawnByNoSensor) << "filled is not seen";
  EXPECT_EQ(filled.color.at(4, 4), kNothing);
  see(Unseen::kSurroundings);
  EXPECT_EQ(wide().color.at(4, 4), kRed);
}

TEST_F(BlendTest, what_a_late_sensor_saw_is_gone_where_another_sees_through_it) {
  const SensorPictures bare = wall(kBlendRendererLens, 3000, kRed);
  for (int i = 0; i < 20; ++i) add(kFirst, kBlendRendererLens, kBlendRendererPose, bare);
  SensorPictures visited = bare;
  fill_box<std::uint16_t>(visited.depth_mm, 20, 12, 44, 36, 1500);
  fill_box(visited.color, 20, 12, 44, 36, kBlue);
  add(kFirst, kBlendRendererLens, kBlendRendererPose, visited);
  const auto shows = [&](RenderMode mode) {
    return draw(eye_of(kBlendRendererLens, kBlendRendererPose), mode).color.at(32, 24);
  };
  for (const RenderMode mode : {RenderMode::kBlend, RenderMode::kAdaptive}) {
    room_->remove(kSecond);
    room_->set_late(kFirst, true);
    EXPECT_EQ(shows(mode), kBlue) << name_of(mode) << ": nobody sees that it is gone";
    add(kSecond, kBlendRendererLens, kBlendRendererPose, bare);
    EXPECT_EQ(shows(mode), kRed) << name_of(mode);
    room_->set_late(kFirst, false);
    EXPECT_EQ(shows(mode), kBlue) << name_of(mode);
  }
  room_->set_late(SensorId{7}, true);  // there is no such sensor
}

TEST_F(BlendTest, an_empty_room_is_the_background) {
  see(Unseen::kSurroundings);
  EXPECT_EQ(middle_from(kBlendRendererEye), kNothing);
}

TEST_F(BlendTest, depth_is_that_of_the_surface) {
  add(kFirst, kBlendRendererLens, kBlendRendererPose, wall(kBlendRendererLens, 2000, kRed));
  const ViewCamera camera = eye_of(kBlendRendererLens, kBlendRendererPose);
  const auto target = OffscreenTarget::create(camera.width, camera.height);
  ASSERT_TRUE(room_->draw(camera, *target, RenderMode::kBlend).ok());
  EXPECT_NEAR(target->read_depth_m(camera).at(20, 20), 2, 0.002);
}

TEST_F(BlendTest, the_same_room_gives_the_same_picture) {
  add(kFirst, kBlendRendererLens, kBlendRendererPose, wall(kBlendRendererLens, 2000, kRed));
  add(kSecond, kBlendRendererLens, kBlendRendererPose, wall(kBlendRendererLens, 2010, kBlue));
  const ViewCamera camera = eye_of(kWideLens, kBlendRendererPose);
  EXPECT_EQ(draw(camera, RenderMode::kBlend).color, draw(camera, RenderMode::kBlend).color);
}

}  // namespace
}  // namespace roomcast::render
