// SPDX-License-Identifier: Apache-2.0
#include "bench/render/view_classes.h"

#include <gtest/gtest.h>

#include "roomcast/render/surface/sensor_pictures_fixture.h"

namespace roomcast::bench {
namespace {

/// Looks along the world's z from its origin; the colour camera is 20 cm to the right.
TrueSensor sensor_before(const DepthImage& depth_mm) {
  TrueSensor sensor;
  sensor.calibration.depth = render::pinhole(depth_mm.width(), depth_mm.height(), 64);
  sensor.calibration.color = render::pinhole(256, 192, 256);
  sensor.calibration.color_from_depth.translation_m = Eigen::Vector3d(-0.2, 0, 0);
  sensor.depth_mm = depth_mm;
  return sensor;
}

TEST(ColorSight, sees_a_wall_and_nothing_behind_it_or_outside_the_picture) {
  const ColorSight sight(sensor_before(DepthImage(64, 48, 2000)));
  EXPECT_TRUE(sight.sees({0.2, 0, 2}));
  EXPECT_FALSE(sight.sees({0.2, 0, 2.5}));
  EXPECT_FALSE(sight.sees({-2, 0, 2}));
  EXPECT_FALSE(sight.sees({0, 0, -1}));
}

TEST(ColorSight, does_not_see_what_something_in_front_hides_from_the_colour_camera) {
  DepthImage depth(64, 48, 2000);
  render::fill_box<std::uint16_t>(depth, 30, 0, 40, 48, 1000);
  const ColorSight sight(sensor_before(depth));
  // The depth camera sees past the box's left edge; the colour camera, further right, does not.
  EXPECT_FALSE(sight.sees({-0.12, 0, 2}));
  EXPECT_TRUE(sight.sees({-0.6, 0, 2}));
}

TEST(Classify, differences_between_two_instants_move_with_a_border_and_specks_do_not) {
  TruthViewEntry entry;
  entry.camera.width = entry.camera.height = 40;
  entry.camera.vertical_fov_rad = 1.5;
  TruthView now{ColorImage(40, 40, render::kRed), DepthImage(40, 40, 2000), MaskImage(40, 40, 1)};
  TruthView then = now;
  render::fill_box(then.color, 10, 10, 20, 20, render::kGreen);
  then.color.at(30, 30) = render::kBlue;
  const ViewClasses classes = classify(entry, now, then, {}, {});
  EXPECT_NE(classes.moving.at(15, 15), 0);
  EXPECT_NE(classes.moving.at(8, 15), 0);
  EXPECT_EQ(classes.moving.at(7, 15), 0);
  EXPECT_EQ(classes.moving.at(30, 30), 0);
}

TEST(Classify, colour_is_valid_where_both_cameras_of_a_sensor_see_the_surface) {
  TruthViewEntry entry;
  entry.camera.world_from_view = render::optical_from_view();  // the eye looks along the world's z
  entry.camera.width = 64;
  entry.camera.height = 48;
  entry.camera.vertical_fov_rad = 2 * std::atan(24.0 / 64);
  TruthView now{ColorImage(64, 48, render::kRed), DepthImage(64, 48, 2000), MaskImage(64, 48, 1)};
  render::fill_box<std::uint8_t>(now.seen, 0, 0, 64, 10, 2);  // seen by another sensor only
  const std::vector<ColorSight> sights = {ColorSight(sensor_before(DepthImage(64, 48, 2000)))};
  const ViewClasses classes = classify(entry, now, now, sights, {});
  EXPECT_NE(classes.colored.at(40, 24), 0);
  EXPECT_EQ(classes.colored.at(40, 5), 0);
}

}  // namespace
}  // namespace roomcast::bench
