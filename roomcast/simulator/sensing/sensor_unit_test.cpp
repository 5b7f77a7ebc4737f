// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/sensor_unit.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

constexpr CameraModel kModels[] = {CameraModel::kKinect2, CameraModel::kAzure, CameraModel::kD435};

TEST(SensorUnit, lenses_are_legal_and_see_their_whole_picture) {
  for (const CameraModel model : kModels) {
    SensingOptions options;
    options.camera = model;
    const SensorUnit unit = make_unit(options, 1, 2);
    for (const CameraIntrinsics& lens : {unit.exact.depth, unit.exact.color, unit.reported.depth}) {
      ASSERT_TRUE(lens.check().ok());
      const auto rays = ray_table(lens);
      for (std::size_t i = 0; i < rays.view().pixel_count(); ++i)
        ASSERT_TRUE(rays.data()[i].allFinite()) << name_of(model);
    }
  }
}

TEST(SensorUnit, reported_lenses_are_nearly_exact) {
  for (int index = 0; index < 8; ++index) {
    const SensorUnit unit = make_unit({}, 5, index);
    const CameraIntrinsics &exact = unit.exact.depth, &reported = unit.reported.depth;
    EXPECT_NE(exact.fx, reported.fx);
    EXPECT_NEAR(reported.fx / exact.fx, 1.0, kFocalError);
    EXPECT_NEAR(reported.cx, exact.cx, kDepthCentreError_px);
    EXPECT_NEAR(unit.reported.color.cy, unit.exact.color.cy, kColorCentreError_px);
    EXPECT_EQ(reported.k1, exact.k1);
    const RigidTransform error =
        unit.exact.color_from_depth * unit.reported.color_from_depth.inverse();
    EXPECT_LT(Eigen::AngleAxisd(error.rotation).angle(), std::sqrt(3.0) * kExtrinsicError_rad);
    EXPECT_LT(
        (unit.exact.color_from_depth.translation_m - unit.reported.color_from_depth.translation_m)
            .norm(),
        std::sqrt(3.0) * kExtrinsicError_m);
  }
}

TEST(SensorUnit, a_clean_unit_has_exact_calibration_and_even_colours) {
  const SensorUnit unit = make_unit(SensingOptions().clean(), 1, 1);
  EXPECT_EQ(unit.exact.depth, unit.reported.depth);
  EXPECT_EQ(unit.exact.color, unit.reported.color);
  EXPECT_EQ(unit.color_gain, (std::array<float, 3>{1, 1, 1}));
}

TEST(SensorUnit, units_differ_in_lens_and_colour_by_index_and_seed) {
  const SensorUnit one = make_unit({}, 1, 0), two = make_unit({}, 1, 1),
                   other = make_unit({}, 2, 0);
  EXPECT_NE(one.exact.depth.fx, two.exact.depth.fx);
  EXPECT_NE(one.exact.depth.fx, other.exact.depth.fx);
  EXPECT_NE(one.color_gain, two.color_gain);
  for (const float gain : two.color_gain) EXPECT_NEAR(gain, 1.0F, 0.12F);
}

TEST(SensorProfile, half_colour_sees_the_same_in_half_the_pixels) {
  const CameraIntrinsics full = profile_of(CameraModel::kKinect2, false).nominal.color;
  const CameraIntrinsics half = profile_of(CameraModel::kKinect2, true).nominal.color;
  EXPECT_EQ(half.width, 960);
  const Eigen::Vector3d point(0.4, -0.3, 2.0);
  const Eigen::Vector2d in_full = *project(full, point), in_half = *project(half, point);
  EXPECT_LT(
      (0.5 * (in_full + Eigen::Vector2d(0.5, 0.5)) - Eigen::Vector2d(0.5, 0.5) - in_half).norm(),
      1e-9);
}

TEST(SensingOptions, cameras_have_names) {
  for (const CameraModel model : kModels) EXPECT_EQ(camera_model_named(name_of(model)), model);
  EXPECT_FALSE(camera_model_named("leica"));
}

}  // namespace
}  // namespace roomcast::simulator
