// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/visibility/told_views.h"

#include <numbers>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/wire/control_check.h"
#include "roomcast/wire/visibility_check.h"

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;
using testing::IsEmpty;

constexpr SensorId kLeft{0}, kRight{1};

RoomTime moment(nanoseconds time) {
  return RoomTime(1h + time);
}

ViewCone cone_at(float x) {
  return {{x, 1.6F, 0}, {0, 0, -1}, {.half_angle_rad = 0.7}};
}

ViewTaker taker(SensorId sensor) {
  return {sensor, {Eigen::Matrix3d::Identity(), {1, 0, 0}}};
}

/// The messages that are sent when they are due, if heads have moved.
std::vector<ToldViews::News> tell(ToldViews& views, const std::vector<ViewCone>& cones,
                                  const std::vector<ViewTaker>& takers, nanoseconds time) {
  views.expect_change(moment(time));
  return views.update(cones, takers, std::max(*views.next(), moment(time)));
}

TEST(ToldViews, a_cone_is_told_in_the_frame_of_each_sensor) {
  ToldViews views;
  ViewTaker turned = taker(kRight);
  turned.world_from_depth.rotation =
      Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const auto news = tell(views, {cone_at(3)}, {taker(kLeft), turned}, 0s);
  ASSERT_EQ(news.size(), 2U);
  const wire::pb::ViewCone &left = news[0].watched.cones(0), &right = news[1].watched.cones(0);
  EXPECT_NEAR(left.eye().x(), 2, 1e-5);
  EXPECT_NEAR(left.eye().y(), 1.6, 1e-5);
  EXPECT_NEAR(left.forward().z(), -1, 1e-5);
  EXPECT_NEAR(left.half_angle(), 0.7, 1e-5);
  EXPECT_FALSE(left.has_up()) << "it is round";
  EXPECT_NEAR(right.eye().x(), -2, 1e-5);
  EXPECT_NEAR(right.forward().z(), 1, 1e-5);
}

TEST(ToldViews, the_sides_of_a_picture_are_told_in_the_frame_of_each_sensor) {
  ToldViews views;
  ViewCone wide = cone_at(3);
  wide.angles = {.half_angle_rad = 0.9, .half_width_rad = 0.8, .half_height_rad = 0.5};
  wide.up = Eigen::Vector3f::UnitY();
  ViewTaker tilted = taker(kLeft);  // its y axis points down, as cameras' do
  tilted.world_from_depth.rotation =
      Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto news = tell(views, {wide}, {tilted}, 0s);
  ASSERT_EQ(news.size(), 1U);
  const wire::pb::ViewCone& told = news[0].watched.cones(0);
  EXPECT_NEAR(told.up().y(), -1, 1e-5);
  EXPECT_NEAR(told.half_width(), 0.8, 1e-5);
  EXPECT_NEAR(told.half_height(), 0.5, 1e-5);
  wide.up = Eigen::Vector3f::UnitX();
  EXPECT_EQ(tell(views, {wide}, {tilted}, 1s).size(), 1U) << "the head rolled";
}

TEST(ToldViews, a_head_that_moves_a_hundred_times_a_second_is_told_ten_times) {
  ToldViews views;
  int told = 0;
  for (int i = 0; i < 200; ++i) {
    const RoomTime now = moment(i * 10ms);
    views.expect_change(now);
    if (*views.next() <= now)
      told += static_cast<int>(
          views.update({cone_at(static_cast<float>(i % 3))}, {taker(kLeft)}, now).size());
  }
  EXPECT_GE(told, 10);
  EXPECT_LE(told, 21);
}

TEST(ToldViews, small_changes_are_not_told) {
  ToldViews views;
  ASSERT_EQ(tell(views, {cone_at(0)}, {taker(kLeft)}, 0s).size(), 1U);
  EXPECT_THAT(tell(views, {cone_at(0.01F)}, {taker(kLeft)}, 1s), IsEmpty());
  EXPECT_EQ(tell(views, {cone_at(0.05F)}, {taker(kLeft)}, 2s).size(), 1U);
}

TEST(ToldViews, when_a_head_rests_it_is_told_once_more) {
  ToldViews views;
  EXPECT_FALSE(views.next());
  ASSERT_EQ(tell(views, {cone_at(0), cone_at(0.3F)}, {taker(kLeft)}, 0s).size(), 1U);
  ASSERT_TRUE(views.next());
  const auto news = views.update({cone_at(0)}, {taker(kLeft)}, *views.next());
  ASSERT_EQ(news.size(), 1U);
  EXPECT_EQ(news[0].watched.cones_size(), 1);
  EXPECT_FALSE(views.next());
}

TEST(ToldViews, that_somebody_gets_everything_is_told_at_once_and_once) {
  ToldViews views;
  ASSERT_EQ(tell(views, {cone_at(0)}, {taker(kLeft), taker(kRight)}, 0s).size(), 2U);
  const auto news = views.update({}, {taker(kLeft), taker(kRight)}, moment(1ms));
  ASSERT_EQ(news.size(), 2U);
  EXPECT_EQ(news[0].watched.cones_size(), 0);
  EXPECT_THAT(views.update({}, {taker(kLeft), taker(kRight)}, moment(2ms)), IsEmpty());
}

TEST(ToldViews, more_viewers_than_fit_are_told_as_somebody_who_gets_everything) {
  ToldViews views;
  std::vector<ViewCone> cones(wire::kMaxViewCones, cone_at(0));
  ASSERT_EQ(tell(views, cones, {taker(kLeft)}, 0s).size(), 1U);
  cones.push_back(cone_at(0));
  const auto news = tell(views, cones, {taker(kLeft)}, 1s);
  ASSERT_EQ(news.size(), 1U);
  EXPECT_EQ(news[0].watched.cones_size(), 0);
}

TEST(ToldViews, a_sensor_without_a_pose_sends_everything) {
  ToldViews views;
  ASSERT_EQ(tell(views, {cone_at(0)}, {taker(kLeft)}, 0s).size(), 1U);
  const auto news = views.update({cone_at(0)}, {}, moment(1s));
  ASSERT_EQ(news.size(), 1U);
  EXPECT_EQ(news[0].sensor, kLeft);
  EXPECT_EQ(news[0].watched.cones_size(), 0);
}

TEST(ToldViews, a_sensor_that_has_joined_anew_is_told_again) {
  ToldViews views;
  ASSERT_EQ(tell(views, {cone_at(0)}, {taker(kLeft)}, 0s).size(), 1U);
  views.forget_sensor(kLeft);
  EXPECT_EQ(tell(views, {cone_at(0)}, {taker(kLeft)}, 1s).size(), 1U);
}

TEST(ToldViews, what_is_told_passes_the_wire_however_far_away_a_head_is) {
  ToldViews views;
  ViewTaker far_away = taker(kLeft);
  far_away.world_from_depth.translation_m.x() = -9'999;
  const auto news = tell(views, {cone_at(9'999)}, {far_away}, 0s);
  ASSERT_EQ(news.size(), 1U);
  wire::pb::Control control;
  *control.mutable_watched_from() = news[0].watched;
  EXPECT_TRUE(wire::check_control(control));
}

}  // namespace
}  // namespace roomcast::hub
