// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/planar_texture.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"

namespace roomcast::alignment {
namespace {

/// The same room with another poster on the wall that the first two corners look at.
RoomFixture with_another_poster() {
  RoomFixture room;
  room.repainted = {Eigen::Vector3d(-0.8, 1.0, -2.1), Eigen::Vector3d(0.8, 2.4, -1.9)};
  return room;
}

PlanarTexture prints_of(const ViewFixture& a, const ViewFixture& b) {
  return compare_planar_texture(*a.view, *b.view, {true_pose(a, b), {}, {}});
}

TEST(PlanarTexture, two_views_of_one_room_agree) {
  const PlanarTexture prints = prints_of(first_corner(), second_corner());
  EXPECT_GT(prints.judged, 0.1);
  EXPECT_GT(prints.correlation(), 0.8);
  EXPECT_LT(prints.conflict(), 0.002);
}

TEST(PlanarTexture, another_poster_on_a_wall_is_counted) {
  const auto other = view_fixture(with_another_poster(), "s1", second_corner().world_from_depth);
  const PlanarTexture same = prints_of(first_corner(), second_corner());
  const PlanarTexture prints = prints_of(first_corner(), other);
  EXPECT_GT(prints.conflict(), 0.01);
  EXPECT_LT(prints.conflict(), 0.3);
  EXPECT_NEAR(prints.judged, same.judged, 0.1 * same.judged);
}

/// A room with a post so near to one sensor that its two cameras see the background behind the post
/// differently.
RoomFixture with_a_post_before_the_second_corner() {
  RoomFixture room;
  room.boxes.push_back({Eigen::Vector3d(-1.3, 0, 0.85), Eigen::Vector3d(-1.1, 2.0, 1.05)});
  return room;
}

TEST(PlanarTexture, the_outline_of_what_stands_before_a_wall_is_no_print) {
  const RoomFixture room = with_a_post_before_the_second_corner();
  const PlanarTexture prints =
      prints_of(view_fixture(room, "s0", first_corner().world_from_depth),
                view_fixture(room, "s1", second_corner().world_from_depth));
  EXPECT_GT(prints.judged, 0.1);
  EXPECT_EQ(prints.contradicting, 0);
}

/// The same greys, but redder where brighter.
ViewFixture tinted(const ViewFixture& plain, double redness) {
  CalibrationBundle bundle = bundle_fixture({}, "s", plain.world_from_depth);
  for (int y = 0; y < bundle.color.height(); ++y) {
    for (int x = 0; x < bundle.color.width(); ++x) {
      Rgb8& color = bundle.color.at(x, y);
      const double more = std::clamp(0.75 * redness * (color.g - 124.0), -60.0, 60.0);
      const double red = color.g + more, rest = color.g - more / 3;  // r + 2 g + b is unchanged
      color = {static_cast<std::uint8_t>(std::clamp(red, 0.0, 255.0)),
               static_cast<std::uint8_t>(std::clamp(rest, 0.0, 255.0)),
               static_cast<std::uint8_t>(std::clamp(rest, 0.0, 255.0))};
    }
  }
  return {plain.world_from_depth, std::make_shared<const SensorView>(*make_sensor_view(bundle))};
}

TEST(PlanarTexture, of_another_hue_are_counted_though_their_greys_agree) {
  const PlanarTexture prints =
      prints_of(tinted(first_corner(), -0.5), tinted(second_corner(), 0.5));
  EXPECT_GT(prints.correlation(), 0.8);
  EXPECT_LT(prints.conflict(), 0.002);
  EXPECT_GT(prints.hue_conflict(), 0.8);
}

/// The same view from a monochrome camera.
ViewFixture in_greys(const ViewFixture& plain) {
  CalibrationBundle bundle = bundle_fixture({}, "s", plain.world_from_depth);
  for (int y = 0; y < bundle.color.height(); ++y) {
    for (int x = 0; x < bundle.color.width(); ++x) {
      Rgb8& color = bundle.color.at(x, y);
      const auto grey = static_cast<std::uint8_t>((color.r + 2 * color.g + color.b) / 4);
      color = {grey, grey, grey};
    }
  }
  return {plain.world_from_depth, std::make_shared<const SensorView>(*make_sensor_view(bundle))};
}

TEST(PlanarTexture, a_camera_that_sees_only_greys_has_no_other_hues) {
  const PlanarTexture prints = prints_of(in_greys(first_corner()), tinted(second_corner(), 0.7));
  EXPECT_GT(prints.correlation(), 0.8);
  EXPECT_EQ(prints.hue_conflict(), 0);
}

TEST(PlanarTexture, cameras_that_see_a_hue_more_or_less_strongly_agree) {
  EXPECT_EQ(prints_of(first_corner(), second_corner()).hue_conflict(), 0);
  EXPECT_LT(prints_of(first_corner(), tinted(second_corner(), 0.15)).hue_conflict(), 0.02);
  const PlanarTexture both = prints_of(tinted(first_corner(), 0.7), tinted(second_corner(), 0.45));
  EXPECT_LT(both.hue_conflict(), 0.05);
}

TEST(PlanarTexture, what_is_a_little_aside_is_no_contradiction) {
  RigidTransform aside = true_pose(first_corner(), second_corner());
  aside.translation_m.x() += 0.01;
  const PlanarTexture prints =
      compare_planar_texture(*first_corner().view, *second_corner().view, {aside, {}, {}});
  EXPECT_LT(prints.conflict(), 0.01);
}

/// The same view with colours shifted right by `pixels` of the colour camera.
ViewFixture with_colors_aside(const ViewFixture& plain, int pixels) {
  CalibrationBundle bundle = bundle_fixture({}, "s", plain.world_from_depth);
  const ColorImage straight = bundle.color;
  for (int y = 0; y < straight.height(); ++y) {
    for (int x = 0; x < straight.width(); ++x)
      bundle.color.at(x, y) = straight.at(std::clamp(x - pixels, 0, straight.width() - 1), y);
  }
  return {plain.world_from_depth, std::make_shared<const SensorView>(*make_sensor_view(bundle))};
}

TEST(PlanarTexture, colors_that_lie_aside_of_their_surfaces_are_no_other_prints) {
  const PlanarTexture prints = prints_of(first_corner(), with_colors_aside(second_corner(), 8));
  EXPECT_GT(prints.judged, 0.1);
  EXPECT_LT(prints.correlation(), 0.6);
  EXPECT_LT(prints.conflict(), 0.002);
}

TEST(PlanarTexture, views_that_share_nothing_say_nothing) {
  RigidTransform away = true_pose(first_corner(), second_corner());
  away.translation_m.z() += 20;
  const PlanarTexture prints =
      compare_planar_texture(*first_corner().view, *second_corner().view, {away, {}, {}});
  EXPECT_EQ(prints.judged, 0);
  EXPECT_EQ(prints.conflict(), 0);
  EXPECT_EQ(prints.correlation(), 0);
}

}  // namespace
}  // namespace roomcast::alignment
