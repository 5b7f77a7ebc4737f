// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/hole_registration.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

constexpr int kWidth = 60, kHeight = 50;
constexpr Rgb8 kWall{200, 180, 160}, kDark{20, 20, 25};

template <class T>
void fill_box(Image<T>& image, int x0, int y0, int x1, int y1, T value) {
  for (int y = y0; y < y1; ++y)
    std::fill(image.view().row(y) + x0, image.view().row(y) + x1, value);
}

/// Both cameras at the same position with the same lens, so that expected values can be computed by
/// hand.
SensorCalibration one_eye() {
  SensorCalibration calibration;
  calibration.depth = {kWidth, kHeight, 50, 50, 29.5, 24.5};
  calibration.color = calibration.depth;
  return calibration;
}

class HoleRegistrationTest : public testing::Test {
 protected:
  void SetUp() override {
    for (int i = 0; i < 5; ++i) see();
  }
  void see() { ASSERT_TRUE(registration->run(depth, color, out).ok()); }
  /// Removes the readings in the box.
  void lose(int x0, int y0, int x1, int y1) { fill_box<std::uint16_t>(depth, x0, y0, x1, y1, 0); }
  void paint(int x0, int y0, int x1, int y1, Rgb8 with) { fill_box(color, x0, y0, x1, y1, with); }

  Result<HoleRegistration> registration = HoleRegistration::create(one_eye());
  DepthImage depth{kWidth, kHeight, 3000};
  ColorImage color{kWidth, kHeight, kWall};
  RegisteredColor out;
};

TEST_F(HoleRegistrationTest, a_dark_object_without_readings_is_shown_in_its_own_colour) {
  lose(20, 15, 40, 35);
  paint(20, 15, 40, 35, kDark);
  see();
  EXPECT_EQ(out.color.at(30, 25), kDark);
  EXPECT_EQ(out.seen.at(30, 25), 0) << "it has no surface";
  EXPECT_EQ(registration->fresh().at(30, 25), 255);
  EXPECT_EQ(out.color.at(10, 25), kWall);
}

TEST_F(HoleRegistrationTest, the_same_wall_without_its_readings_keeps_its_color) {
  lose(20, 15, 40, 35);
  paint(20, 15, 40, 35, {195, 185, 158});  // noise
  see();
  EXPECT_EQ(out.color.at(30, 25), kWall);
  EXPECT_EQ(registration->fresh().at(30, 25), 0);
}

TEST_F(HoleRegistrationTest, a_few_pixels_are_no_object) {
  lose(20, 15, 23, 18);
  paint(20, 15, 23, 18, kDark);
  see();
  EXPECT_EQ(out.color.at(21, 16), kWall);
  EXPECT_EQ(registration->fresh().at(21, 16), 0);
}

TEST_F(HoleRegistrationTest, the_wall_returns_when_the_object_has_gone) {
  lose(20, 15, 40, 35);
  paint(20, 15, 40, 35, kDark);
  see();
  paint(20, 15, 40, 35, kWall);
  see();
  EXPECT_EQ(out.color.at(30, 25), kWall);
}

TEST_F(HoleRegistrationTest, an_object_before_the_color_camera_alone_is_not_taken_for_the_wall) {
  SensorCalibration apart = one_eye();
  apart.color_from_depth.translation_m.x() = 0.2;  // sees behind the edge of the near surface
  registration = HoleRegistration::create(apart);
  for (int i = 0; i < 5; ++i) see();
  const auto hidden_from_color = [&] {
    fill_box<std::uint16_t>(depth, 20, 0, 30, kHeight, 1000);
    lose(10, 0, 20, kHeight);
  };
  hidden_from_color();
  paint(0, 0, kWidth, kHeight, kDark);  // the camera sees this everywhere
  see();
  EXPECT_EQ(registration->fresh().at(25, 25), 255);
  int kept = 0;
  for (int x = 10; x < 40; ++x) kept += registration->fresh().at(x, 25) == 0 ? 1 : 0;
  EXPECT_GT(kept, 3) << "behind the near thing the camera sees no wall";
}

TEST(FarthestDepth, a_farther_surface_takes_over_when_it_was_read_several_times) {
  FarthestDepth farthest(1, 1);
  const auto after = [&](std::uint16_t reading, int times) {
    for (int i = 0; i < times; ++i) farthest.learn(DepthImage(1, 1, reading));
    return farthest.depth_mm().at(0, 0);
  };
  EXPECT_EQ(after(1500, 3), 1500);
  EXPECT_EQ(after(3000, 2), 1500);
  EXPECT_EQ(after(3000, 1), 3000);
  EXPECT_EQ(after(1500, 20), 3000) << "somebody stands before it";
  EXPECT_EQ(after(0, 20), 3000);
  EXPECT_NEAR(after(3008, 30), 3008, 4);
}

TEST(FarthestDepth, readings_of_one_surface_agree_up_to_the_largest) {
  FarthestDepth farthest(1, 1);
  for (const std::uint16_t reading : {60'000, 60'100, 60'050})
    farthest.learn(DepthImage(1, 1, reading));
  EXPECT_EQ(farthest.depth_mm().at(0, 0), 60'050);
  for (int i = 0; i < 80; ++i) farthest.learn(DepthImage(1, 1, 65'000));
  EXPECT_NEAR(farthest.depth_mm().at(0, 0), 65'000, 4);
}

TEST(SparseCover, lies_between_readings_that_agree_and_not_beside_them) {
  const DepthImage wall(kWidth, kHeight, 3000);
  DepthImage depth(kWidth, kHeight);
  for (int y = 10; y < 40; y += 4)
    for (int x = 20; x < 50; x += 4) depth.at(x, y) = 1500;
  SparseCover cover(kWidth, kHeight);
  cover.find(depth, wall);
  EXPECT_EQ(cover.between_mm(33, 25), 1500);
  EXPECT_EQ(cover.between_mm(8, 25), 0);
  EXPECT_EQ(cover.between_mm(16, 25), 0) << "beside it";
  cover.find(wall, wall);
  EXPECT_EQ(cover.between_mm(33, 25), 0) << "the wall is not before itself";
}

}  // namespace
}  // namespace roomcast
