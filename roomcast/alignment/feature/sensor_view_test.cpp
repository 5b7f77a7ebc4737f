// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/sensor_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"
#include "roomcast/alignment/feature/walk_views_fixture.h"

namespace roomcast::alignment {
namespace {

TEST(SensorView, sees_features_planes_and_floor) {
  const SensorView& view = *first_corner().view;
  EXPECT_GT(view.picture_features.size(), 200u);
  EXPECT_GT(view.rectified_features.size(), 200u);
  EXPECT_GE(view.planes.size(), 3u);
  EXPECT_TRUE(view.floor.has_value());
  EXPECT_EQ(view.name, "s0");
}

TEST(SensorView, of_a_bundle_that_is_none_says_why) {
  CalibrationBundle bundle = bundle_fixture({}, "s7", corner_pose(2, 1.5));
  bundle.color = {};
  EXPECT_THAT(make_sensor_view(bundle).error().message, testing::HasSubstr("s7"));
}

TEST(SensorView, of_one_flat_wall_says_what_to_do) {
  const RigidTransform facing = world_from_optical_looking_at({0, 1.3, 1.2}, {0, 1.3, 2});
  EXPECT_THAT(make_sensor_view(bundle_fixture({}, "s7", facing)).error().message,
              testing::HasSubstr("one flat surface"));
}

TEST(SensorView, of_readings_without_any_surface_says_what_to_do) {
  CalibrationBundle bundle = bundle_fixture({}, "s7", corner_pose(2, 1.5));
  for (int y = 0; y < bundle.depth_mm.height(); ++y) {
    for (int x = 0; x < bundle.depth_mm.width(); ++x) {
      bundle.depth_mm.at(x, y) = (x + y) % 2 == 0 ? 800 : 4000;
    }
  }
  EXPECT_THAT(make_sensor_view(bundle).error().message, testing::HasSubstr("turn it towards"));
}

TEST(SensorView, with_a_depth_scale_keeps_the_name_that_it_was_given) {
  SensorView view = *walk_view({}, "s7", corner_pose(2, 1.5));
  view.name = "desk";
  const auto scaled = with_depth_scale(view, 1.04);
  ASSERT_TRUE(scaled);
  EXPECT_EQ(scaled->name, "desk");
}

}  // namespace
}  // namespace roomcast::alignment
