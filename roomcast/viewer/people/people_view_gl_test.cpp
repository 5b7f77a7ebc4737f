// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/render/gl/shader_variables_fixture.h"
#include "roomcast/viewer/people/people_view.h"
#include "roomcast/viewer/people/shaders.h"

namespace roomcast::viewer {
namespace {

constexpr int kPeopleViewSide = 200;
constexpr Rgb8 kBackground = {20, 20, 20};
constexpr Rgb8 kBlue = {30, 60, 240};

class PeopleViewTest : public render::GlTest {
 protected:
  void SetUp() override {
    render::GlTest::SetUp();
    auto made = PeopleView::create();
    ASSERT_TRUE(made.ok()) << made.error().message;
    people.emplace(std::move(*made));
    room.self = ViewerId{1};
    room.people.push_back({ViewerId{2}, "Ada", kBlue, client::PersonPose{}});
    room.people[0].pose->world_from_head = {Eigen::Vector3d(-1, 1, -1).asDiagonal(),
                                            {0, 1.6, -1.5}};
    camera.width = camera.height = kPeopleViewSide;
    camera.world_from_view.translation_m = {0, 1.6, 0};
  }
  void TearDown() override {
    people.reset();
    render::GlTest::TearDown();
  }

  ColorImage draw() {
    auto target = render::OffscreenTarget::create(kPeopleViewSide, kPeopleViewSide);
    target->clear(kBackground);
    people->follow(room);
    people->draw(camera, *target);
    sensors = target->read_sensors();
    depth_m = target->read_depth_m(camera);
    return target->read_color();
  }

  static bool is_blue(Rgb8 color) { return color.b > 1.5 * color.r && color.b > 80; }

  /// The pixel of a world point.
  Eigen::Vector2i pixel_of(const Eigen::Vector3d& world_m) const {
    const Eigen::Vector3d view_m = camera.world_from_view.inverse() * world_m;
    const double focal = render::focal_length_px(camera);
    return {static_cast<int>(kPeopleViewSide / 2.0 - focal * view_m.x() / view_m.z()),
            static_cast<int>(kPeopleViewSide / 2.0 + focal * view_m.y() / view_m.z())};
  }

  std::optional<PeopleView> people;
  client::RoomSnapshot room;
  render::ViewCamera camera;
  Image<std::int32_t> sensors;
  Image<float> depth_m;
};

TEST_F(PeopleViewTest, has_its_shaders_variables_where_they_are_declared) {
  const int programs = render::expect_programs_as_declared([](auto& visitor) {
    render::shaders::visit_all(visitor);
    shaders::visit_all(visitor);
  });
  EXPECT_EQ(programs, 2);
}

TEST_F(PeopleViewTest, a_head_has_its_size_its_colour_and_its_depth) {
  room.people[0].pose->world_from_head.rotation.setIdentity();  // seen from behind, without visor
  const ColorImage picture = draw();
  const auto middle = pixel_of({0, 1.6, -1.5});
  EXPECT_TRUE(is_blue(picture.at(middle.x(), middle.y())));
  EXPECT_NEAR(depth_m.at(middle.x(), middle.y()), 1.5 - 0.115, 0.01);
  const auto inside = pixel_of({0.09, 1.6, -1.5}), outside = pixel_of({0.13, 1.6, -1.5});
  EXPECT_TRUE(is_blue(picture.at(inside.x(), inside.y())));
  EXPECT_EQ(picture.at(outside.x(), outside.y()), kBackground);
  EXPECT_EQ(sensors.at(middle.x(), middle.y()), render::kDrawnByNoSensor);
}

TEST_F(PeopleViewTest, somebody_who_stands_where_the_eye_is_does_not_hide_the_room) {
  room.people[0].pose->world_from_head.translation_m = {0.05, 1.6, 0.1};
  EXPECT_EQ(draw(), ColorImage(kPeopleViewSide, kPeopleViewSide, kBackground));
  room.people.push_back({ViewerId{3}, "Grace", kBlue, room.people[0].pose});
  room.people[1].pose->world_from_head.translation_m = {0, 1.6, -1.5};
  const ColorImage picture = draw();
  const auto middle = pixel_of({0, 1.6 + 0.1, -1.5});
  EXPECT_TRUE(is_blue(picture.at(middle.x(), middle.y()))) << "others are seen";
}

TEST_F(PeopleViewTest, the_visor_shows_the_viewing_direction) {
  room.people[0].pose->world_from_head.rotation.setIdentity();  // away: -z is forward
  const ColorImage back = draw();
  room.people[0].pose->world_from_head.rotation = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  people->follow({});  // no easing
  const ColorImage front = draw();
  const auto visor = pixel_of({0, 1.62, -1.42});
  EXPECT_TRUE(is_blue(back.at(visor.x(), visor.y())));
  EXPECT_FALSE(is_blue(front.at(visor.x(), visor.y())));
}

TEST_F(PeopleViewTest, a_name_stands_above_the_head_and_faces_the_eye) {
  const ColorImage picture = draw();
  const auto plate = pixel_of({0, 1.6 + 0.27, -1.5});
  int bright = 0, dark = 0;
  for (int y = plate.y() - 4; y <= plate.y() + 4; ++y) {
    for (int x = plate.x() - 15; x <= plate.x() + 15; ++x) {
      const Rgb8 color = picture.at(x, y);
      bright += color.g > 150 ? 1 : 0;
      dark += color.g < 19 ? 1 : 0;
    }
  }
  EXPECT_GT(bright, 10) << "letters";
  EXPECT_GT(dark, 50) << "the plate behind them";
}

TEST_F(PeopleViewTest, a_beam_goes_from_the_hand_to_its_target) {
  room.people[0].pose->world_from_right_hand =
      RigidTransform{Eigen::Matrix3d::Identity(), {0.3, 1.4, -1.5}};
  room.people[0].pose->pointer = client::PointerBeam{{0.3, 1.4, -1.5}, {-0.4, 1.3, -1.5}};
  const ColorImage picture = draw();
  for (const Eigen::Vector3d& place :
       {Eigen::Vector3d(0.3, 1.4, -1.5), Eigen::Vector3d(-0.05, 1.35, -1.5),
        Eigen::Vector3d(-0.4, 1.3, -1.5)}) {
    const auto pixel = pixel_of(place);
    bool is_near = false;
    for (int dy = -1; dy <= 1; ++dy) is_near |= is_blue(picture.at(pixel.x(), pixel.y() + dy));
    EXPECT_TRUE(is_near) << place.transpose();
  }
}

TEST_F(PeopleViewTest, the_viewer_sees_its_own_hands_and_beam_but_no_head) {
  room.people[0].id = room.self;
  client::PersonPose own;
  own.world_from_head = camera.world_from_view;
  own.world_from_left_hand = RigidTransform{Eigen::Matrix3d::Identity(), {-0.2, 1.5, -0.6}};
  people->set_own(own);
  const ColorImage picture = draw();
  const auto hand = pixel_of({-0.2, 1.5, -0.6});
  EXPECT_TRUE(is_blue(picture.at(hand.x(), hand.y())));
  EXPECT_EQ(picture.at(kPeopleViewSide / 2, kPeopleViewSide / 2), kBackground);
}

TEST_F(PeopleViewTest, two_eyes_see_what_each_sees_alone) {
  room.people[0].pose->pointer = client::PointerBeam{{0.3, 1.4, -1.5}, {-0.4, 1.3, -1.5}};
  render::ViewCamera left = camera, right = camera;
  left.world_from_view.translation_m.x() -= 0.4;  // the eyes see the head at different places
  right.world_from_view.translation_m.x() += 0.5;
  auto both = render::OffscreenTarget::create(kPeopleViewSide, kPeopleViewSide, 2);
  ASSERT_TRUE(both.ok());
  both->clear(kBackground);
  people->follow(room);
  people->draw({left, right}, *both);
  for (const int eye : {0, 1}) {
    camera = eye == 0 ? left : right;
    const ColorImage alone = draw(), together = both->read_color(eye);
    int others = 0;
    for (std::size_t i = 0; i < alone.view().pixel_count(); ++i)
      others += std::abs(alone.data()[i].g - together.data()[i].g) > 1 ? 1 : 0;
    EXPECT_LT(others, 20) << "of eye " << eye;
    EXPECT_NE(alone, ColorImage(kPeopleViewSide, kPeopleViewSide, kBackground));
  }
}

TEST(WorldFromLabel, faces_the_eye_and_stays_upright_even_from_right_below) {
  RigidTransform head;
  head.translation_m = {1, 1.6, 1};
  for (const Eigen::Vector3d& eye :
       {Eigen::Vector3d(4, 1, 1), Eigen::Vector3d(1, 0, 1), Eigen::Vector3d(-1, 5, -2)}) {
    RigidTransform view;
    view.translation_m = eye;
    const Eigen::Matrix3d label = world_from_label(view, head).rotation;
    EXPECT_TRUE((label.transpose() * label).isIdentity(1e-9));
    EXPECT_NEAR(label.col(1).y(), 1, 1e-9);
    EXPECT_GE(label.col(2).dot(eye - head.translation_m), 0);
  }
}

TEST_F(PeopleViewTest, any_bytes_can_be_a_name) {
  const LabelFont font;
  EXPECT_TRUE(font.lay_out("", 0.05F).corners.empty());
  EXPECT_EQ(font.lay_out("Ada", 0.05F).corners.size(), 3U * 6U);
  EXPECT_FALSE(font.lay_out("\xff\xfe\x80", 0.05F).corners.empty());
  const LabelText longest = font.lay_out(std::string(500, 'W'), 0.05F);
  EXPECT_LE(longest.width_m, kWidestLabel_m);
}

}  // namespace
}  // namespace roomcast::viewer
