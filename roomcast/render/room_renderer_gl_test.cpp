// SPDX-License-Identifier: Apache-2.0
// Tests common to all render modes; tests of meshes and points are next to their renderers.
#include <limits>

#include "roomcast/render/room_fixture.h"
#include "roomcast/render/room_renderer.h"

namespace roomcast::render {
namespace {

using Eigen::Vector3d;

// A sensor of 64x48 pixels, and an eye at the same pose with the same focal length and twice the
// field: one depth pixel covers one pixel.
const CameraIntrinsics kRoomRendererLens = pinhole(64, 48, 60);
const CameraIntrinsics kWideLens = pinhole(128, 96, 60);
const RigidTransform kPose = world_from_optical_looking_at(Vector3d(1, 1.5, 2), Vector3d(3, 1, -4));
constexpr int kLeft = 32, kTop = 24, kRight = 96, kBottom = 72;  // the sensor's part of the picture

class EveryMode : public RoomTest, public ::testing::WithParamInterface<RenderMode> {
 protected:
  Picture draw_wide() { return draw(eye_of(kWideLens, kPose), GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Modes, EveryMode,
                         ::testing::Values(RenderMode::kSplats, RenderMode::kMesh,
                                           RenderMode::kAdaptive, RenderMode::kBlend),
                         [](const auto& mode) { return std::string(name_of(mode.param)); });

TEST_P(EveryMode, colours_twice_as_fine_as_depth_have_their_places) {
  SensorPictures pictures = wall(kRoomRendererLens, 2000, kRed);
  pictures.color = ColorImage(2 * kRoomRendererLens.width, 2 * kRoomRendererLens.height, kRed);
  fill_box(pictures.color, kRoomRendererLens.width, 0, 2 * kRoomRendererLens.width,
           2 * kRoomRendererLens.height, kBlue);
  add(kFirst, kRoomRendererLens, kPose, pictures);
  const Picture picture = draw_wide();
  const int middle = (kLeft + kRight) / 2, row = (kTop + kBottom) / 2;
  EXPECT_EQ(picture.color.at(middle - 3, row), kRed);
  EXPECT_EQ(picture.color.at(middle + 3, row), kBlue);
  add(kFirst, kRoomRendererLens, kPose, wall(kRoomRendererLens, 2000, kGreen));  // and back
  EXPECT_EQ(draw_wide().color.at(middle, row), kGreen);
}

TEST_P(EveryMode, a_wall_covers_the_pixels_that_its_sensor_saw_and_no_others) {
  add(kFirst, kRoomRendererLens, kPose, wall(kRoomRendererLens, 2000, kRed));
  const Picture picture = draw_wide();
  const int border = 1;  // half a point extends beyond it, half a cell is missing
  for (int y = 0; y < kWideLens.height; ++y) {
    for (int x = 0; x < kWideLens.width; ++x) {
      const bool inside =
          x >= kLeft + border && x < kRight - border && y >= kTop + border && y < kBottom - border;
      const bool outside =
          x < kLeft - border || x >= kRight + border || y < kTop - border || y >= kBottom + border;
      if (inside || outside) {
        ASSERT_EQ(picture.color.at(x, y), inside ? kRed : kNothing) << x << "," << y;
      }
    }
  }
}

TEST_P(EveryMode, left_right_top_and_bottom_stay_where_they_are) {
  SensorPictures pictures = wall(kRoomRendererLens, 2000, kRed);
  fill_box(pictures.color, 32, 0, 64, 24, kGreen);
  fill_box(pictures.color, 0, 24, 32, 48, kBlue);
  fill_box(pictures.color, 32, 24, 64, 48, kYellow);
  add(kFirst, kRoomRendererLens, kPose, pictures);
  const Picture picture = draw_wide();
  EXPECT_EQ(picture.color.at(kLeft + 4, kTop + 4), kRed);
  EXPECT_EQ(picture.color.at(kRight - 5, kTop + 4), kGreen);
  EXPECT_EQ(picture.color.at(kLeft + 4, kBottom - 5), kBlue);
  EXPECT_EQ(picture.color.at(kRight - 5, kBottom - 5), kYellow);
}

TEST_P(EveryMode, the_nearer_surface_hides_the_farther_one_of_another_sensor) {
  for (const bool near_is_first : {true, false}) {
    add(near_is_first ? kFirst : kSecond, kRoomRendererLens, kPose,
        wall(kRoomRendererLens, 1000, kGreen));
    add(near_is_first ? kSecond : kFirst, kRoomRendererLens, kPose,
        wall(kRoomRendererLens, 1100, kRed));
    EXPECT_EQ(draw_wide().color.at(64, 48), kGreen);
  }
}

TEST_P(EveryMode, pixels_without_depth_draw_nothing) {
  SensorPictures pictures = wall(kRoomRendererLens, 2000, kRed);
  fill_box<std::uint16_t>(pictures.depth_mm, 20, 10, 40, 30, 0);
  add(kFirst, kRoomRendererLens, kPose, pictures);
  const Picture picture = draw_wide();
  constexpr int kRim = 4;  // blend mode extends the edges of objects
  for (int y = kTop + 10 + kRim; y < kTop + 30 - kRim; ++y) {
    for (int x = kLeft + 20 + kRim; x < kLeft + 40 - kRim; ++x) {
      ASSERT_EQ(picture.color.at(x, y), kNothing) << x << "," << y;
    }
  }
}

TEST_P(EveryMode, what_the_color_camera_did_not_see_is_grey) {
  SensorPictures pictures = wall(kRoomRendererLens, 2000, kRed);
  fill_box<std::uint8_t>(pictures.seen, 20, 10, 40, 30, 0);
  add(kFirst, kRoomRendererLens, kPose, pictures);
  const Picture picture = draw_wide();
  const Rgb8 grey = picture.color.at(kLeft + 30, kTop + 20);
  EXPECT_EQ(grey.r, grey.g);
  EXPECT_EQ(grey.g, grey.b);
  EXPECT_NEAR(grey.r, 128, 1);
  EXPECT_EQ(picture.color.at(kLeft + 50, kTop + 20), kRed);
}

TEST_P(EveryMode, a_surface_without_color_gives_way_to_a_sensor_that_saw_it) {
  SensorPictures unseen = wall(kRoomRendererLens, 2000, kRed);
  unseen.seen = MaskImage(kRoomRendererLens.width, kRoomRendererLens.height, 0);
  add(kFirst, kRoomRendererLens, kPose, unseen);
  add(kSecond, kRoomRendererLens, kPose,
      wall(kRoomRendererLens, 2020, kGreen));  // 2 cm farther: within depth noise
  EXPECT_EQ(draw_wide().color.at(64, 48), kGreen);

  add(kSecond, kRoomRendererLens, kPose,
      wall(kRoomRendererLens, 2200, kGreen));  // a different surface, well behind
  EXPECT_NEAR(draw_wide().color.at(64, 48).g, 128, 1);
}

TEST_P(EveryMode, every_pixel_knows_which_sensor_drew_it) {
  SensorPictures half = wall(kRoomRendererLens, 1500, kRed);
  fill_box<std::uint16_t>(half.depth_mm, 32, 0, 64, 48, 0);
  add(kFirst, kRoomRendererLens, kPose, half);
  add(SensorId{65535}, kRoomRendererLens, kPose, wall(kRoomRendererLens, 2000, kGreen));
  const Picture picture = draw_wide();
  EXPECT_EQ(picture.sensors.at(kLeft + 10, 48), 1);
  EXPECT_EQ(picture.sensors.at(kRight - 10, 48), 65535);
  EXPECT_EQ(picture.sensors.at(5, 5), kDrawnByNoSensor);
}

TEST_P(EveryMode, an_unplaced_sensor_is_drawn_and_never_mixed_with_others) {
  add(kFirst, kRoomRendererLens, kPose, wall(kRoomRendererLens, 2000, kRed));
  add(kSecond, kRoomRendererLens, kPose,
      wall(kRoomRendererLens, 2010, kGreen));  // within the mixing distance
  room_->set_unplaced(kSecond, true);
  EXPECT_EQ(draw_wide().color.at(64, 48), kRed);
  add(kSecond, kRoomRendererLens, kPose, wall(kRoomRendererLens, 1900, kGreen));
  EXPECT_EQ(draw_wide().color.at(64, 48), kGreen) << "it is there, by itself";
  room_->remove(kFirst);
  EXPECT_EQ(draw_wide().color.at(64, 48), kGreen);
}

TEST_P(EveryMode, a_moved_sensor_keeps_its_picture) {
  add(kFirst, kRoomRendererLens, RigidTransform{}, wall(kRoomRendererLens, 2000, kRed));
  ASSERT_TRUE(room_->set_sensor(kFirst, kRoomRendererLens, kPose).ok());
  EXPECT_EQ(draw_wide().color.at(64, 48), kRed);
}

TEST_P(EveryMode, a_sensor_with_another_lens_starts_empty) {
  add(kFirst, kRoomRendererLens, kPose, wall(kRoomRendererLens, 2000, kRed));
  ASSERT_TRUE(room_->set_sensor(kFirst, pinhole(32, 32, 30), kPose).ok());
  EXPECT_EQ(draw_wide().color, ColorImage(kWideLens.width, kWideLens.height, kNothing));
}

TEST_P(EveryMode, a_removed_sensor_is_gone) {
  add(kFirst, kRoomRendererLens, kPose, wall(kRoomRendererLens, 1000, kRed));
  add(kSecond, kRoomRendererLens, kPose, wall(kRoomRendererLens, 2000, kGreen));
  room_->remove(kFirst);
  EXPECT_EQ(draw_wide().color.at(64, 48), kGreen);
}

TEST_P(EveryMode, the_newest_picture_is_drawn) {
  add(kFirst, kRoomRendererLens, kPose, wall(kRoomRendererLens, 1000, kRed));
  EXPECT_EQ(draw_wide().color.at(64, 48), kRed);
  add(kFirst, kRoomRendererLens, kPose, wall(kRoomRendererLens, 0, kRed));
  EXPECT_EQ(draw_wide().color.at(64, 48), kNothing);
  add(kFirst, kRoomRendererLens, kPose, wall(kRoomRendererLens, 3000, kBlue));
  EXPECT_EQ(draw_wide().color.at(64, 48), kBlue);
}

TEST_P(EveryMode, rows_of_a_larger_picture_can_be_uploaded) {
  const CameraIntrinsics large_lens = pinhole(100, 60, 60);
  SensorPictures large = wall(large_lens, 0, kRed);
  fill_box<std::uint16_t>(large.depth_mm, 0, 0, kRoomRendererLens.width, kRoomRendererLens.height,
                          2000);
  const auto corner = [](const auto& image) {
    auto view = image.view();
    view.width = kRoomRendererLens.width;
    view.height = kRoomRendererLens.height;
    return view;
  };
  ASSERT_TRUE(room_->set_sensor(kFirst, kRoomRendererLens, kPose).ok());
  ASSERT_TRUE(
      room_->upload(kFirst, corner(large.depth_mm), corner(large.color), corner(large.seen)).ok());
  const Picture picture = draw_wide();
  EXPECT_EQ(picture.color.at(kLeft + 2, kBottom - 3), kRed);
  EXPECT_EQ(picture.color.at(kRight - 3, kBottom - 3), kRed);
}

TEST_P(EveryMode, the_same_room_gives_the_same_picture) {
  add(kFirst, kRoomRendererLens, kPose, wall(kRoomRendererLens, 2000, kGreen));
  add(kSecond, kRoomRendererLens, kPose, wall(kRoomRendererLens, 2000, kRed));
  const Picture once = draw_wide(), again = draw_wide();
  EXPECT_EQ(once.color, again.color);
  EXPECT_EQ(once.sensors, again.sensors);
}

using Room = RoomTest;

TEST_F(Room, a_picture_of_an_unknown_sensor_is_refused) {
  const SensorPictures pictures = wall(kRoomRendererLens, 1000, kRed);
  const Status status =
      room_->upload(SensorId{7}, pictures.depth_mm, pictures.color, pictures.seen);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kNotFound);
  EXPECT_NE(status.error().message.find('7'), std::string::npos);
}

TEST_F(Room, a_picture_of_another_size_is_refused) {
  ASSERT_TRUE(room_->set_sensor(kFirst, kRoomRendererLens, kPose).ok());
  const SensorPictures right = wall(kRoomRendererLens, 1000, kRed);
  const SensorPictures wrong = wall(pinhole(64, 47, 60), 1000, kRed);
  const auto code = [&](DepthView depth, ColorView color, MaskView seen) {
    const Status status = room_->upload(kFirst, depth, color, seen);
    return status.ok() ? std::string("taken") : status.error().message;
  };
  EXPECT_EQ(code(wrong.depth_mm, right.color, right.seen),
            "the depth picture is 64x47 but the sensor's is 64x48");
  EXPECT_EQ(code(right.depth_mm, wrong.color, right.seen),
            "the colour picture is 64x47 but the sensor's is 64x48");
  EXPECT_EQ(code(right.depth_mm, right.color, wrong.seen),
            "the mask picture is 64x47 but the sensor's is 64x48");
}

TEST_F(Room, an_impossible_sensor_is_refused_and_changes_nothing) {
  ASSERT_TRUE(room_->set_sensor(kFirst, kRoomRendererLens, kPose).ok());
  RigidTransform nowhere;
  nowhere.translation_m.y() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(room_->set_sensor(kFirst, kRoomRendererLens, nowhere).error().code,
            ErrorCode::kInvalidArgument);
  EXPECT_EQ(room_->set_sensor(kFirst, pinhole(64, 48, -1), kPose).error().code,
            ErrorCode::kInvalidArgument);
  EXPECT_EQ(room_->set_sensor(kFirst, pinhole(4096, 1025, 60), kPose).error().code,
            ErrorCode::kTooLarge);
  const SensorPictures pictures = wall(kRoomRendererLens, 1000, kRed);
  EXPECT_TRUE(room_->upload(kFirst, pictures.depth_mm, pictures.color, pictures.seen).ok());
}

TEST_F(Room, more_sensors_than_the_limit_are_refused) {
  const CameraIntrinsics tiny = pinhole(2, 2, 2);
  for (std::uint16_t id = 0; id < kMaxRenderedSensors; ++id) {
    ASSERT_TRUE(room_->set_sensor(SensorId{id}, tiny, kPose).ok());
  }
  EXPECT_EQ(room_->set_sensor(SensorId{1000}, tiny, kPose).error().code, ErrorCode::kTooLarge);
  EXPECT_TRUE(room_->set_sensor(SensorId{0}, pinhole(3, 3, 3), kPose).ok());
  room_->remove(SensorId{5});
  EXPECT_TRUE(room_->set_sensor(SensorId{1000}, tiny, kPose).ok());
}

TEST_F(Room, a_camera_that_does_not_fit_the_picture_is_refused) {
  const Result<OffscreenTarget> target = OffscreenTarget::create(64, 48);
  ASSERT_TRUE(target.ok());
  ViewCamera camera = eye_of(kWideLens, kPose);
  EXPECT_EQ(room_->draw(camera, *target, RenderMode::kMesh).error().code,
            ErrorCode::kInvalidArgument);
  camera = eye_of(kRoomRendererLens, kPose);
  camera.near_m = -1;
  EXPECT_EQ(room_->draw(camera, *target, RenderMode::kMesh).error().code,
            ErrorCode::kInvalidArgument);
}

TEST_F(Room, illegal_options_are_refused) {
  for (const int step : {0, kMaxGridStep + 1}) {
    options_.mesh.grid_step = step;
    EXPECT_EQ(room_->set_options(options_).error().code, ErrorCode::kInvalidArgument);
  }
  options_.mesh = {};
  options_.mesh.max_gap_m = -0.1;
  EXPECT_EQ(room_->set_options(options_).error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace roomcast::render
