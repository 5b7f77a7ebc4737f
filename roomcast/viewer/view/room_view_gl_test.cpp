// SPDX-License-Identifier: Apache-2.0
#include <chrono>

#include <gtest/gtest.h>

#include "roomcast/render/gl/gl_context.h"
#include "roomcast/viewer/view/room_view.h"

namespace roomcast::viewer {
namespace {

constexpr int kSide = 64;

std::shared_ptr<const client::SensorPicture> wall(Rgb8 color) {
  auto picture = std::make_shared<client::SensorPicture>();
  picture->frame.depth_mm = DepthImage(kSide, kSide, 2000);
  picture->frame.color = ColorImage(kSide, kSide, color);
  picture->frame.color_seen = MaskImage(kSide, kSide, 255);
  return picture;
}

client::RoomSnapshot room_with(std::shared_ptr<const client::SensorPicture> picture) {
  client::RoomSensor sensor;
  sensor.online = true;
  sensor.calibration.depth = {
      .width = kSide, .height = kSide, .fx = 60, .fy = 60, .cx = 31.5, .cy = 31.5};
  sensor.pose.world_from_depth = world_from_optical_looking_at({0, 1, 0}, {0, 1, -1});
  sensor.picture = std::move(picture);
  client::RoomSnapshot room;
  room.sensors.push_back(sensor);
  return room;
}

class RoomViewTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(context.ok()) << context.error().message;
    auto created = RoomView::create();
    ASSERT_TRUE(created.ok()) << created.error().message;
    view.emplace(std::move(*created));
  }

  Rgb8 middle_of_picture(render::RenderMode mode = render::RenderMode::kSplats) {
    auto target = render::OffscreenTarget::create(kSide, kSide);
    render::ViewCamera camera;
    camera.width = camera.height = kSide;
    camera.world_from_view = render::world_from_view_looking_at({0, 1, 0}, {0, 1, -1});
    EXPECT_TRUE(view->draw(camera, *target, mode).ok());
    return target->read_color().at(kSide / 2, kSide / 2);
  }

  /// The first column in which the wall is seen.
  int left_of_red() {
    auto target = render::OffscreenTarget::create(kSide, kSide);
    render::ViewCamera camera;
    camera.width = camera.height = kSide;
    camera.world_from_view = render::world_from_view_looking_at({0, 1, 1}, {0, 1, -1});
    EXPECT_TRUE(view->draw(camera, *target, render::RenderMode::kAdaptive).ok());
    const ColorImage picture = target->read_color();
    int x = 0;
    while (x < kSide && picture.at(x, kSide / 2).r < 150) ++x;
    return x;
  }

  Result<render::EglContext> context = render::EglContext::create();
  std::optional<RoomView> view;
};

TEST_F(RoomViewTest, a_model_is_seen_until_another_one_comes_whole) {
  constexpr Rgb8 kGreen = {40, 180, 90};
  model::RoomMesh wall;
  wall.points_m = {{-4, -4, -3}, {4, -4, -3}, {0, 8, -3}};
  wall.colors.assign(3, kGreen);
  wall.triangles = {{0, 1, 2}};
  ASSERT_TRUE(
      view->take_model({.is_whole = true, .version = 1, .pieces = {{{0, 0, 0}, wall}}}).ok());
  EXPECT_EQ(middle_of_picture(render::RenderMode::kStill), kGreen);
  ASSERT_TRUE(view->take_model({.is_whole = false, .version = 2, .pieces = {}}).ok());
  EXPECT_EQ(middle_of_picture(render::RenderMode::kStill), kGreen);
  ASSERT_TRUE(view->take_model({.is_whole = true, .version = 3, .pieces = {}}).ok());
  EXPECT_NE(middle_of_picture(render::RenderMode::kStill), kGreen);
}

TEST_F(RoomViewTest, a_paused_sensor_shows_nothing_until_its_next_picture) {
  client::RoomSnapshot room = room_with(wall({200, 10, 10}));
  ASSERT_TRUE(view->show(room).ok());
  room.sensors[0].is_paused = true;
  ASSERT_TRUE(view->show(room).ok());
  EXPECT_NE(middle_of_picture(), (Rgb8{200, 10, 10}));
  room.sensors[0].is_paused = false;
  room.sensors[0].picture = wall({10, 200, 10});
  ASSERT_TRUE(view->show(room).ok());
  EXPECT_EQ(middle_of_picture(), (Rgb8{10, 200, 10}));
}

TEST_F(RoomViewTest, the_newest_picture_is_drawn) {
  ASSERT_TRUE(view->show(room_with(wall({200, 10, 10}))).ok());
  EXPECT_EQ(middle_of_picture(), (Rgb8{200, 10, 10}));
  ASSERT_TRUE(view->show(room_with(wall({10, 200, 10}))).ok());
  EXPECT_EQ(middle_of_picture(), (Rgb8{10, 200, 10}));
}

TEST_F(RoomViewTest, a_sensor_that_left_is_not_drawn) {
  auto room = room_with(wall({200, 10, 10}));
  ASSERT_TRUE(view->show(room).ok());
  room.sensors[0].online = false;
  ASSERT_TRUE(view->show(room).ok());
  EXPECT_NE(middle_of_picture(), (Rgb8{200, 10, 10}));
}

TEST_F(RoomViewTest, a_sensor_that_is_switched_off_is_not_drawn) {
  view->hide({SensorId{0}});
  ASSERT_TRUE(view->show(room_with(wall({200, 10, 10}))).ok());
  EXPECT_NE(middle_of_picture(), (Rgb8{200, 10, 10}));
  view->hide({});
  ASSERT_TRUE(view->show(room_with(wall({200, 10, 10}))).ok());
  EXPECT_EQ(middle_of_picture(), (Rgb8{200, 10, 10}));
}

TEST_F(RoomViewTest, people_are_hidden_by_walls_and_hide_walls) {
  client::RoomSnapshot room = room_with(wall({200, 10, 10}));
  client::RoomPerson person{ViewerId{4}, "Ada", {10, 10, 250}, client::PersonPose{}};
  person.pose->world_from_head.translation_m = {0, 1, -3};
  room.people = {person};
  ASSERT_TRUE(view->show(room).ok());
  EXPECT_EQ(middle_of_picture(), (Rgb8{200, 10, 10})) << "the wall is 2 m away";
  room.people[0].pose->world_from_head.translation_m = {0, 1, -1};
  room.people[0].pose->world_from_head.rotation =
      Eigen::Vector3d(-1, 1, -1).asDiagonal();  // facing away: the visor is dark
  ASSERT_TRUE(view->show(room).ok());
  while (view->people().advance(0.1)) {
  }
  const Rgb8 head = middle_of_picture();
  EXPECT_GT(head.b, head.r);
}

TEST_F(RoomViewTest, what_moves_is_drawn_between_the_times_of_two_sensors) {
  client::RoomSnapshot room = room_with(wall({200, 10, 10}));
  room.sensors[0].pose.source = PoseSource::kGiven;
  client::RoomSensor later = room.sensors[0];
  later.id = SensorId{1};
  auto nothing = std::make_shared<client::SensorPicture>(*later.picture);
  nothing->frame.depth_mm = DepthImage(kSide, kSide);
  nothing->capture_time = RoomTime(std::chrono::milliseconds(60));
  later.picture = nothing;
  room.sensors.push_back(later);
  ASSERT_TRUE(view->show(room).ok());
  const int seen_at = left_of_red();

  room.sensors[0].picture = wall({200, 10, 10});
  constexpr int kCells = scene_flow::cells_along(kSide);
  const auto rightwards = std::make_shared<const scene_flow::FlowField>(
      kCells, kCells, scene_flow::CellFlow{{4, 0, 0}, 3});  // 12 cm in 30 ms
  ASSERT_TRUE(view->show(room, {{SensorId{0}, rightwards}}).ok());
  EXPECT_GE(left_of_red(), seen_at + 3);
}

TEST_F(RoomViewTest, a_sensor_without_a_picture_is_no_error) {
  EXPECT_TRUE(view->show(room_with(nullptr)).ok());
  EXPECT_NE(middle_of_picture(), (Rgb8{200, 10, 10}));
}

TEST(StartView, is_where_the_hub_says) {
  client::RoomSnapshot room;
  EXPECT_GT(world_from_start_view(room).translation_m.y(), 1);
  room.start_pose = RigidTransform{Eigen::Matrix3d::Identity(), {1, 2, 3}};
  EXPECT_EQ(world_from_start_view(room).translation_m, Eigen::Vector3d(1, 2, 3));
}

}  // namespace
}  // namespace roomcast::viewer
