// SPDX-License-Identifier: Apache-2.0
// Tests the remembered background of a room in blend mode.
#include "roomcast/render/blend/background_model.h"
#include "roomcast/render/room_fixture.h"

namespace roomcast::render {
namespace {

using Eigen::Vector3d;

const CameraIntrinsics kBackgroundModelLens = pinhole(64, 48, 60);
const Vector3d kBackgroundModelEye(0, 1.5, 0), kBackgroundModelAhead(0, 1.5, -2);
const RigidTransform kBackgroundModelPose =
    world_from_optical_looking_at(kBackgroundModelEye, kBackgroundModelAhead);
constexpr int kBackgroundModelMiddleX = 32, kBackgroundModelMiddleY = 24;

/// A red wall at 3 m whose middle is hidden by a blue person at 1.5 m.
SensorPictures with_somebody() {
  SensorPictures pictures = wall(kBackgroundModelLens, 3000, kRed);
  fill_box<std::uint16_t>(pictures.depth_mm, 20, 0, 44, 48, 1500);
  fill_box(pictures.color, 20, 0, 44, 48, kBlue);
  return pictures;
}

/// The same wall without readings in its middle.
SensorPictures with_a_gap() {
  SensorPictures pictures = wall(kBackgroundModelLens, 3000, kRed);
  fill_box<std::uint16_t>(pictures.depth_mm, 20, 0, 44, 48, 0);
  fill_box<std::uint8_t>(pictures.seen, 20, 0, 44, 48, 0);
  return pictures;
}

class BackgroundModelTest : public RoomTest {
 protected:
  void show(const SensorPictures& pictures, int times = 1) {
    for (int i = 0; i < times; ++i)
      add(kFirst, kBackgroundModelLens, kBackgroundModelPose, pictures);
  }
  Rgb8 middle() {
    return draw(eye_of(kBackgroundModelLens, kBackgroundModelPose), RenderMode::kBlend)
        .color.at(kBackgroundModelMiddleX, kBackgroundModelMiddleY);
  }
};

TEST_F(BackgroundModelTest, a_wall_that_was_seen_before_is_there_when_it_is_not_read) {
  show(wall(kBackgroundModelLens, 3000, kRed), 10);
  show(with_a_gap());
  EXPECT_EQ(middle(), kRed);
}

TEST_F(BackgroundModelTest, what_was_read_a_few_times_is_not_background) {
  show(wall(kBackgroundModelLens, 3000, kRed), 3);
  show(with_a_gap());
  EXPECT_EQ(middle(), kNothing);
}

TEST_F(BackgroundModelTest, somebody_hides_the_background_and_it_is_there_when_he_has_gone) {
  show(wall(kBackgroundModelLens, 3000, kRed), 10);
  show(with_somebody(), 30);
  EXPECT_EQ(middle(), kBlue);
  show(with_a_gap());
  EXPECT_EQ(middle(), kRed);
}

TEST_F(BackgroundModelTest, who_stood_there_from_the_beginning_is_forgotten_when_he_goes) {
  show(with_somebody(), 10);
  show(wall(kBackgroundModelLens, 3000, kRed), 12);
  show(with_a_gap());
  EXPECT_EQ(middle(), kRed);
}

TEST_F(BackgroundModelTest, background_gives_way_at_once_where_its_sensor_looks_through_it) {
  show(with_somebody(), 10);
  show(wall(kBackgroundModelLens, 3000, kRed));
  EXPECT_EQ(middle(), kRed);
}

TEST_F(BackgroundModelTest, background_gives_way_where_another_sensor_looks_through_it) {
  show(with_somebody(), 10);
  show(with_a_gap());
  EXPECT_EQ(middle(), kBlue) << "remembered";
  const RigidTransform aside =
      world_from_optical_looking_at(Vector3d(1, 1.5, 0), Vector3d(0, 1.5, -3));
  add(kSecond, kBackgroundModelLens, aside, wall(kBackgroundModelLens, 3100, kGreen));
  show(with_a_gap());
  EXPECT_NE(middle(), kBlue);
}

TEST_F(BackgroundModelTest, somebody_is_not_transparent_from_behind_and_a_wall_is) {
  show(wall(kBackgroundModelLens, 3000, kRed), 10);
  show(with_somebody());
  const auto from_behind = [&](double distance_m) {
    const RigidTransform pose =
        world_from_optical_looking_at(Vector3d(0, 1.5, -distance_m), kBackgroundModelEye);
    return draw(eye_of(kBackgroundModelLens, pose), RenderMode::kBlend)
        .color.at(kBackgroundModelMiddleX, kBackgroundModelMiddleY);
  };
  EXPECT_EQ(from_behind(2.5), kBlue) << "between the person and the wall";
  EXPECT_EQ(from_behind(5), kBlue) << "through the wall, as into a doll's house";
  show(wall(kBackgroundModelLens, 3000, kRed), 12);
  EXPECT_EQ(from_behind(5), kNothing);
}

TEST_F(BackgroundModelTest, noise_of_what_stands_still_is_averaged_out) {
  const auto shown_depth = [&](std::uint16_t depth_mm) {
    show(wall(kBackgroundModelLens, depth_mm, kRed));
    const ViewCamera camera = eye_of(kBackgroundModelLens, kBackgroundModelPose);
    const auto target = OffscreenTarget::create(camera.width, camera.height);
    EXPECT_TRUE(room_->draw(camera, *target, RenderMode::kBlend).ok());
    return target->read_depth_m(camera).at(kBackgroundModelMiddleX, kBackgroundModelMiddleY);
  };
  for (int i = 0; i < 40; ++i)
    show(wall(kBackgroundModelLens, static_cast<std::uint16_t>(i % 2 ? 2992 : 3008), kRed));
  EXPECT_NEAR(shown_depth(3008), 3.0F, 0.001F);
  EXPECT_NEAR(shown_depth(2992), 3.0F, 0.001F);
}

TEST_F(BackgroundModelTest,
       a_sensor_that_sends_nothing_new_looks_the_same_however_often_it_is_drawn) {
  show(with_a_gap());
  const ColorImage before =
      draw(eye_of(kBackgroundModelLens, kBackgroundModelPose), RenderMode::kBlend).color;
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(room_->set_sensor(kFirst, kBackgroundModelLens, RigidTransform{}).ok());
    ASSERT_TRUE(room_->set_sensor(kFirst, kBackgroundModelLens, kBackgroundModelPose).ok());
    EXPECT_EQ(draw(eye_of(kBackgroundModelLens, kBackgroundModelPose), RenderMode::kBlend).color,
              before)
        << i;
  }
}

TEST_F(BackgroundModelTest, a_light_that_is_switched_on_is_seen_at_once) {
  show(wall(kBackgroundModelLens, 3000, {80, 80, 80}), 20);
  show(wall(kBackgroundModelLens, 3000, {160, 160, 160}));
  EXPECT_EQ(middle(), (Rgb8{160, 160, 160}));
}

}  // namespace
}  // namespace roomcast::render
