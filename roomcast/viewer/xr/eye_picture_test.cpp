// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/eye_picture.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::viewer::xr {
namespace {

constexpr XrFovf kLeftEye = {-0.80F, 0.70F, 0.75F, -0.72F};

double focal_px(const EyePicture& picture) {
  return 0.5 * picture.drawn.height / std::tan(picture.vertical_fov_rad / 2);
}

TEST(EyePicture, holds_all_that_the_eye_sees_and_little_more) {
  const auto picture = eye_picture(kLeftEye, {640, 640});
  ASSERT_TRUE(picture.ok());
  EXPECT_LE(picture->fov.angleLeft, kLeftEye.angleLeft);
  EXPECT_GE(picture->fov.angleRight, kLeftEye.angleRight);
  EXPECT_GE(picture->fov.angleUp, kLeftEye.angleUp);
  EXPECT_LE(picture->fov.angleDown, kLeftEye.angleDown);
  EXPECT_NEAR(picture->fov.angleLeft, kLeftEye.angleLeft, 0.003);
  EXPECT_LE(picture->part.width, 640);
  EXPECT_LE(picture->part.height, 640);
  EXPECT_GE(std::max(picture->part.width, picture->part.height), 637);
}

TEST(EyePicture, its_angles_are_those_of_its_edges_in_the_drawn_picture) {
  const auto picture = eye_picture(kLeftEye, {700, 640});
  ASSERT_TRUE(picture.ok());
  const double focal = focal_px(*picture);
  const double left = picture->drawn.width / 2.0 - picture->left;
  EXPECT_NEAR(std::tan(-picture->fov.angleLeft) * focal, left, 1e-3);
  EXPECT_NEAR(std::tan(picture->fov.angleRight) * focal, picture->part.width - left, 1e-3);
  const double down = picture->drawn.height / 2.0 - picture->bottom;
  EXPECT_NEAR(std::tan(-picture->fov.angleDown) * focal, down, 1e-3);
  EXPECT_NEAR(std::tan(picture->fov.angleUp) * focal, picture->part.height - down, 1e-3);
  EXPECT_GE(picture->left, 0);
  EXPECT_GE(picture->bottom, 0);
  EXPECT_LE(picture->left + picture->part.width, picture->drawn.width);
  EXPECT_LE(picture->bottom + picture->part.height, picture->drawn.height);
}

TEST(EyePicture, of_a_larger_picture_shows_the_same) {
  const auto picture = eye_picture(kLeftEye, {700, 640});
  ASSERT_TRUE(picture.ok());
  const PictureSize size = {picture->drawn.width + 10, picture->drawn.height + 4};
  const EyePicture larger = with_size(*picture, size);
  EXPECT_EQ(larger.drawn, size);
  EXPECT_EQ(larger.part, picture->part);
  EXPECT_EQ(larger.left, picture->left + 5);
  EXPECT_EQ(larger.bottom, picture->bottom + 2);
  EXPECT_NEAR(focal_px(larger), focal_px(*picture), 1e-9);
}

TEST(EyePicture, an_empty_field_of_view_is_refused) {
  EXPECT_FALSE(eye_picture({0.5F, -0.5F, 0.5F, -0.5F}, {640, 640}).ok());
  EXPECT_FALSE(eye_picture({-1.7F, 0.5F, 0.5F, -0.5F}, {640, 640}).ok());
  EXPECT_FALSE(eye_picture({NAN, 0.5F, 0.5F, -0.5F}, {640, 640}).ok());
  EXPECT_FALSE(eye_picture(kLeftEye, {0, 0}).ok());
  EXPECT_FALSE(eye_picture({-1.4F, 0.0F, 0.1F, -0.1F}, {8000, 100000}).ok());
}

TEST(EyePicture, poses_go_there_and_back) {
  const XrPosef pose = {{0, 0.6F, 0, 0.8F}, {1, 2, 3}};
  const XrPosef back = pose_from_transform(transform_from_pose(pose));
  EXPECT_NEAR(back.orientation.y, 0.6, 1e-6);
  EXPECT_NEAR(back.orientation.w, 0.8, 1e-6);
  EXPECT_EQ(back.position.z, 3);
}

}  // namespace
}  // namespace roomcast::viewer::xr
