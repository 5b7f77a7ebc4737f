// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/axial_noise.h"

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

TEST(AxialNoise, kinect2_values_by_hand) {
  EXPECT_NEAR(kinect2_sigma_mm(2.0F, 0.0F), 1.7F, 1e-5F);  // 1.5 - 1 + 1.2
  EXPECT_NEAR(kinect2_sigma_mm(4.0F, 0.0F), 4.3F, 1e-5F);  // 1.5 - 2 + 4.8
  // theta = pi/4: theta^2 / (pi/2 - theta)^2 = 1, z^1.5 = 8
  EXPECT_NEAR(kinect2_sigma_mm(4.0F, 0.785398F), 4.3F + 0.8F, 1e-4F);
}

TEST(AxialNoise, angles_beyond_72_degrees_count_as_72) {
  EXPECT_EQ(kinect2_sigma_mm(2.0F, 1.4F), kinect2_sigma_mm(2.0F, 1.5707F));
  EXPECT_LT(kinect2_sigma_mm(2.0F, 1.5707F), 10.0F);
}

TEST(AxialNoise, azure_is_like_kinect2_near_and_better_far_within_its_specification) {
  for (const float z : {0.5F, 1.5F, 2.5F}) {
    EXPECT_EQ(azure_sigma_mm(z, 0.3F), kinect2_sigma_mm(z, 0.3F));
  }
  for (const float z : {2.6F, 3.0F, 3.5F, 5.5F}) {
    EXPECT_LT(azure_sigma_mm(z, 0.0F), kinect2_sigma_mm(z, 0.0F));
    EXPECT_LT(azure_sigma_mm(z, 0.0F), 17.0F);
  }
}

TEST(AxialNoise, stereo_grows_with_the_square_of_the_range) {
  // 2 m: 4e6 mm^2 * 0.08 px / (424 px * 50 mm)
  EXPECT_NEAR(stereo_sigma_mm(2.0F, 424.0F, 50.0F, 0.08F), 15.094F, 1e-3F);
  EXPECT_NEAR(stereo_sigma_mm(4.0F, 424.0F, 50.0F, 0.08F), 4.0F * 15.094F, 4e-3F);
}

}  // namespace
}  // namespace roomcast::simulator
