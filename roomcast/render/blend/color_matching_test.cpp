// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/color_matching.h"

#include <gtest/gtest.h>

#include "roomcast/render/surface/sensor_pictures_fixture.h"

namespace roomcast::render {
namespace {

const CameraIntrinsics kLens = pinhole(120, 90, 100);
constexpr SensorId kLeft{1}, kRight{2};
const RigidTransform kHere;

/// Both sensors see the same wall from the same pose.
const std::map<SensorId, RigidTransform> kSamePlace = {{kLeft, kHere}, {kRight, kHere}};

void show(ColorMatching& colors, SensorId sensor, Rgb8 color, std::uint16_t depth_mm = 2000) {
  const SensorPictures pictures = wall(kLens, depth_mm, color);
  for (int i = 0; i < ColorMatching::kEvery; ++i) {
    colors.offer(sensor, kLens, pictures.depth_mm, pictures.color, pictures.seen);
  }
}

void settle(ColorMatching& colors, Rgb8 left, Rgb8 right, std::uint16_t right_depth_mm = 2000) {
  for (int i = 0; i < 10; ++i) {
    show(colors, kLeft, left);
    show(colors, kRight, right, right_depth_mm);
    colors.update(kSamePlace);
  }
}

TEST(ColorMatching, knows_nothing_at_first) {
  EXPECT_EQ(ColorMatching().gain(kLeft), Eigen::Vector3f::Ones());
}

TEST(ColorMatching, makes_two_sensors_agree_half_way) {
  ColorMatching colors;
  settle(colors, {100, 120, 140}, {121, 120, 140});
  const Eigen::Vector3f left = colors.gain(kLeft), right = colors.gain(kRight);
  EXPECT_NEAR(left.x() * 100, right.x() * 121, 0.7F);
  EXPECT_NEAR(left.x(), 1.1F, 0.01F);
  EXPECT_NEAR(right.x(), 1 / 1.1F, 0.01F);
  EXPECT_NEAR(left.y(), 1, 1e-3F);
}

TEST(ColorMatching, follows_a_change_over_several_pictures) {
  ColorMatching colors;
  show(colors, kLeft, {100, 100, 100});
  show(colors, kRight, {121, 121, 121});
  colors.update(kSamePlace);
  const float first = colors.gain(kLeft).x();
  EXPECT_GT(first, 1.01F);
  EXPECT_LT(first, 1.09F);
}

TEST(ColorMatching, compares_nothing_but_the_same_place) {
  ColorMatching colors;
  settle(colors, {100, 100, 100}, {200, 200, 200}, 3000);
  EXPECT_EQ(colors.gain(kLeft), Eigen::Vector3f::Ones());
}

TEST(ColorMatching, takes_nothing_from_what_is_too_dark_or_too_bright) {
  ColorMatching colors;
  settle(colors, {100, 100, 100}, {250, 250, 250});
  EXPECT_EQ(colors.gain(kLeft), Eigen::Vector3f::Ones());
}

TEST(ColorMatching, does_without_sensors_that_have_no_colour_and_those_that_left) {
  ColorMatching colors;
  const SensorPictures pictures = wall(kLens, 2000, kRed);
  colors.offer(kLeft, kLens, pictures.depth_mm, {}, {});
  colors.update(kSamePlace);
  settle(colors, {100, 100, 100}, {121, 121, 121});
  colors.forget(kRight);
  show(colors, kLeft, {100, 100, 100});
  colors.update(kSamePlace);
  EXPECT_EQ(colors.gain(kRight), Eigen::Vector3f::Ones());
}

TEST(ColorMatching, of_a_large_room_takes_turns) {
  ColorMatching colors;
  std::map<SensorId, RigidTransform> poses;
  const auto show_all = [&] {
    for (std::uint16_t i = 0; i < 12; ++i) {
      show(colors, SensorId{i}, i < 6 ? Rgb8{100, 100, 100} : Rgb8{121, 121, 121});
      poses[SensorId{i}] = kHere;
    }
  };
  for (int i = 0; i < 20; ++i) {
    show_all();
    for (int j = 0; j < ColorMatching::kEvery; ++j) colors.update(poses);
  }
  for (std::uint16_t i = 0; i < 12; ++i) {
    EXPECT_NEAR(colors.gain(SensorId{i}).x(), i < 6 ? 1.1F : 1 / 1.1F, 0.01F) << i;
  }
}

TEST(ColorMatching, changes_nothing_while_nothing_is_new) {
  ColorMatching colors;
  show(colors, kLeft, {100, 100, 100});
  show(colors, kRight, {121, 121, 121});
  colors.update(kSamePlace);
  const Eigen::Vector3f once = colors.gain(kLeft);
  colors.update(kSamePlace);
  EXPECT_EQ(colors.gain(kLeft), once);
}

}  // namespace
}  // namespace roomcast::render
