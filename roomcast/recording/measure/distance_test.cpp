// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/measure/distance.h"

#include <gtest/gtest.h>

#include "roomcast/recording/measure/box_room_fixture.h"

namespace roomcast::recording {
namespace {

PickedPlace at(const Eigen::Vector3d& world_m) {
  return {{}, Eigen::Vector2d::Zero(), world_m};
}

TEST(Distance, between_two_walls_is_that_of_the_room) {
  const auto room = box_room();
  const auto measured = measure_distance(room, at({0.5, 1, 2.5}), at({0.5, 1, -2.5}));
  ASSERT_TRUE(measured.ok()) << measured.error().message;
  EXPECT_NEAR(measured->distance_m, 5, 0.004);
  EXPECT_GT(measured->expected_error_m, 0.001);
  EXPECT_LT(measured->expected_error_m, 0.03);
}

TEST(Distance, of_two_pixels_of_a_sensor) {
  const auto room = box_room();
  const auto measured = measure_distance(room, {"a", {40, 100}, {}}, {"a", {200, 60}, {}});
  ASSERT_TRUE(measured.ok());
  const auto truth = [&](double x, double y) {
    const auto ray = *unproject(room[0].depth, {x, y}, 1);
    return Eigen::Vector3d(ray * box_room_z_m(room[0].world_from_depth, ray));
  };
  EXPECT_NEAR(measured->distance_m, (truth(40, 100) - truth(200, 60)).norm(), 0.003);
}

TEST(Distance, errors_of_the_sensors_places_count_between_two_sensors) {
  auto room = box_room();
  const auto of_one = measure_distance(room, {"a", {40, 100}, {}}, {"a", {200, 60}, {}});
  for (auto& sensor : room) sensor.expected_error_m = 0.03;
  const auto still = measure_distance(room, {"a", {40, 100}, {}}, {"a", {200, 60}, {}});
  const auto of_two = measure_distance(room, {"a", {40, 100}, {}}, {"b", {200, 60}, {}});
  EXPECT_EQ(of_one->expected_error_m, still->expected_error_m);
  EXPECT_GT(of_two->expected_error_m, 0.04);
}

TEST(Distance, has_the_error_of_the_rooms_scale_also_between_pixels_of_one_sensor) {
  auto room = box_room();
  const auto known = measure_distance(room, {"a", {40, 100}, {}}, {"a", {200, 60}, {}});
  for (auto& sensor : room) sensor.scale_error = 0.02;
  const auto doubted = measure_distance(room, {"a", {40, 100}, {}}, {"a", {200, 60}, {}});
  EXPECT_EQ(known->by_scale_m, 0);
  EXPECT_EQ(doubted->distance_m, known->distance_m);
  EXPECT_DOUBLE_EQ(doubted->by_scale_m, 0.02 * doubted->distance_m);
  EXPECT_NEAR(doubted->expected_error_m, std::hypot(known->expected_error_m, doubted->by_scale_m),
              1e-9);
}

TEST(Distance, gives_the_reason_when_it_cannot_measure) {
  auto room = box_room();
  EXPECT_EQ(measure_place(room, {"z", {1, 1}, {}}).error().message,
            "there is no placed sensor \"z\"; there is a, b, c, d");
  room[0].depth_mm = DepthImage(room[0].depth.width, room[0].depth.height);
  EXPECT_EQ(measure_place(room, {"a", {40, 40}, {}}).error().code, ErrorCode::kNotFound);
  EXPECT_EQ(measure_place(room, {"a", {-1e9, 1e9}, {}}).error().code, ErrorCode::kNotFound);
  EXPECT_EQ(measure_place(room, at({0, 1.5, 0})).error().code, ErrorCode::kNotFound);
}

TEST(Distance, places_are_pixels_or_points) {
  EXPECT_EQ(parse_place("s0:320,240.5")->pixel, Eigen::Vector2d(320, 240.5));
  EXPECT_EQ(parse_place("a:b:1,2")->sensor, "a:b");
  EXPECT_EQ(*parse_place("1,-0.5,2e0")->world_m, Eigen::Vector3d(1, -0.5, 2));
  for (const char* text : {"", "1,2", "1,2,3,4", "s0:1", ":1,2", "1,2,x", "1,2,", "nan,1,2"})
    EXPECT_FALSE(parse_place(text).ok()) << text;
}

}  // namespace
}  // namespace roomcast::recording
