// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/viewer/view/room_picture.h"
#include "roomcast/viewer/view/wall_room_fixture.h"

namespace roomcast::viewer {
namespace {

client::RoomSnapshot red_room() {
  return room_with_wall(world_from_optical_looking_at({0, 1, 0}, {0, 1, -1}),
                        ColorImage(64, 64, {200, 10, 10}));
}

class RoomPictureTest : public render::GlTest {
 protected:
  void SetUp() override {
    render::GlTest::SetUp();
    auto made = RoomView::create();
    ASSERT_TRUE(made.ok()) << made.error().message;
    view.emplace(std::move(*made));
    picture.emplace();
    ASSERT_TRUE(view->show(red_room()).ok());
    camera.width = camera.height = 80;
    camera.world_from_view = render::world_from_view_looking_at({0.1, 1, 0.3}, {0, 1, -1});
  }
  void TearDown() override {
    picture.reset();
    view.reset();
    render::GlTest::TearDown();
  }

  std::optional<RoomView> view;
  std::optional<RoomPicture> picture;
  render::ViewCamera camera;
};

TEST_F(RoomPictureTest, follows_the_requested_size) {
  ASSERT_TRUE(picture->draw(*view, camera, render::RenderMode::kMesh).ok());
  EXPECT_EQ(picture->target()->width(), 80);
  camera.width = 120;
  ASSERT_TRUE(picture->draw(*view, camera, render::RenderMode::kMesh).ok());
  PictureTarget target({120, 80});
  target.show(*picture->target());
  EXPECT_EQ(target.picture().width(), 120);
  EXPECT_EQ(target.picture().at(60, 40), (Rgb8{200, 10, 10}));
}

TEST_F(RoomPictureTest, the_surface_under_a_pixel_is_where_it_is_in_the_world) {
  ASSERT_TRUE(picture->draw(*view, camera, render::RenderMode::kMesh).ok());
  const auto place_m = surface_at(*picture->target(), camera, 45, 30);
  ASSERT_TRUE(place_m);
  EXPECT_NEAR(place_m->z(), -2, 0.005) << "on the wall";
  const Eigen::Vector3d view_m = camera.world_from_view.inverse() * *place_m;
  const double focal = render::focal_length_px(camera);
  EXPECT_NEAR(40 - focal * view_m.x() / view_m.z(), 45.5, 1e-6);
  EXPECT_NEAR(40 + focal * view_m.y() / view_m.z(), 30.5, 1e-6);
}

TEST_F(RoomPictureTest, an_empty_pixel_has_no_surface) {
  camera.world_from_view = render::world_from_view_looking_at({0, 1, 0}, {0, 1, 1});
  ASSERT_TRUE(picture->draw(*view, camera, render::RenderMode::kMesh).ok());
  EXPECT_FALSE(surface_at(*picture->target(), camera, 40, 40));
  EXPECT_FALSE(surface_at(*picture->target(), camera, -1, 40));
  EXPECT_FALSE(surface_at(*picture->target(), camera, 40, 80));
}

TEST_F(RoomPictureTest, drawing_is_measured_when_it_is_finished) {
  EXPECT_FALSE(picture->take_drawing_time());
  for (int i = 0; i < 9; ++i) {  // more than the timer has queries
    ASSERT_TRUE(picture->draw(*view, camera, render::RenderMode::kMesh).ok());
  }
  glFinish();
  const auto time = picture->take_drawing_time();
  ASSERT_TRUE(time);
  EXPECT_GT(time->count(), 0);
  EXPECT_FALSE(picture->take_drawing_time()) << "each time is returned once";
}

void EPOXY_CALLSPEC answer_with_the_uptime(GLuint, GLenum, GLuint64* elapsed_ns) {
  *elapsed_ns = 4'933'516'600'000;
}

TEST_F(RoomPictureTest, a_drawing_time_longer_than_the_time_since_its_begin_is_not_believed) {
  const auto driver = std::exchange(epoxy_glGetQueryObjectui64v, answer_with_the_uptime);
  ASSERT_TRUE(picture->draw(*view, camera, render::RenderMode::kMesh).ok());
  glFinish();
  EXPECT_FALSE(picture->take_drawing_time());
  epoxy_glGetQueryObjectui64v = driver;
  ASSERT_TRUE(picture->draw(*view, camera, render::RenderMode::kMesh).ok());
  glFinish();
  EXPECT_TRUE(picture->take_drawing_time()) << "the next one is";
}

}  // namespace
}  // namespace roomcast::viewer
