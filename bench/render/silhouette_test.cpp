// SPDX-License-Identifier: Apache-2.0
#include "bench/render/silhouette.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "bench/render/silhouette_score.h"
#include "roomcast/render/surface/sensor_pictures_fixture.h"

namespace roomcast::bench {
namespace {

constexpr int kWidth = 96, kHeight = 72;
constexpr double kFocal_px = 80;
constexpr std::uint16_t kWall_mm = 3000, kPerson_mm = 2000, kShelf_mm = 2500;
constexpr int kLeft = 40, kTop = 20, kRight = 56, kBottom = 60;  // of the person

/// An eye with the picture, the place and the direction of the sensor.
render::ViewCamera eye() {
  render::ViewCamera camera;
  camera.world_from_view = render::optical_from_view();
  camera.width = kWidth;
  camera.height = kHeight;
  camera.vertical_fov_rad = 2 * std::atan(0.5 * kHeight / kFocal_px);
  return camera;
}

StillBackground background_of(const DepthImage& depth_mm) {
  SensorCalibration calibration;
  calibration.depth = render::pinhole(kWidth, kHeight, kFocal_px);
  StillBackground background(calibration, {});
  background.add(depth_mm);
  return background;
}

/// A shelf at the left of a wall.
DepthImage still_room() {
  DepthImage depth_mm(kWidth, kHeight, kWall_mm);
  render::fill_box<std::uint16_t>(depth_mm, 0, 0, 20, kHeight, kShelf_mm);
  return depth_mm;
}

TruthView seen_view(const DepthImage& depth_mm) {
  return {ColorImage(kWidth, kHeight), depth_mm, MaskImage(kWidth, kHeight, 1)};
}

TruthView view_with_person() {
  TruthView view = seen_view(still_room());
  render::fill_box(view.depth_mm, kLeft, kTop, kRight, kBottom, kPerson_mm);
  return view;
}

Silhouette silhouette_in(const TruthView& view) {
  const std::vector<StillBackground> backgrounds = {background_of(still_room())};
  return find_silhouette(eye(), view, backgrounds);
}

int count(const MaskImage& mask) {
  int set = 0;
  for (int i = 0; i < mask.width() * mask.height(); ++i) set += mask.data()[i] != 0;
  return set;
}

constexpr int kPersonPixels = (kRight - kLeft) * (kBottom - kTop);

Image<float> in_metres(const DepthImage& depth_mm) {
  Image<float> depth_m(depth_mm.width(), depth_mm.height());
  for (int y = 0; y < depth_mm.height(); ++y) {
    for (int x = 0; x < depth_mm.width(); ++x) {
      depth_m.at(x, y) = 0.001F * static_cast<float>(depth_mm.at(x, y));
    }
  }
  return depth_m;
}

TEST(StillBackground, is_the_farthest_of_all_frames) {
  StillBackground background = background_of(DepthImage(kWidth, kHeight, kPerson_mm));
  EXPECT_FALSE(background.is_behind({0, 0, 2}));
  background.add(DepthImage(kWidth, kHeight, kWall_mm));
  background.add(DepthImage(kWidth, kHeight, kPerson_mm));
  EXPECT_TRUE(background.is_behind({0, 0, 2}));
  EXPECT_FALSE(background.is_behind({0, 0, 2.95}));
  EXPECT_FALSE(background.is_behind({0, 0, -1}));
  EXPECT_FALSE(background.is_behind({9, 0, 2})) << "outside the picture";
}

TEST(StillBackground, of_no_frames_is_behind_nothing_and_where_nothing_is_ever_hit_behind_all) {
  SensorCalibration calibration;
  calibration.depth = render::pinhole(kWidth, kHeight, kFocal_px);
  StillBackground background(calibration, {});
  EXPECT_FALSE(background.is_behind({0, 0, 2}));
  background.add(DepthImage(kWidth, kHeight, kPerson_mm));
  background.add(DepthImage(kWidth, kHeight, 0));
  EXPECT_TRUE(background.is_behind({0, 0, 2}));
}

TEST(StillBackground, is_in_the_place_of_its_sensor) {
  SensorCalibration calibration;
  calibration.depth = render::pinhole(kWidth, kHeight, kFocal_px);
  RigidTransform a_metre_back;
  a_metre_back.translation_m.z() = -1;
  StillBackground background(calibration, a_metre_back);
  background.add(DepthImage(kWidth, kHeight, kWall_mm));
  EXPECT_TRUE(background.is_behind({0, 0, 1.8}));
  EXPECT_FALSE(background.is_behind({0, 0, 2}));
}

TEST(Silhouette, is_a_box_before_a_wall_and_no_still_edge) {
  const Silhouette found = silhouette_in(view_with_person());
  EXPECT_NE(found.mask.at(kLeft, 40), 0);
  EXPECT_NE(found.mask.at(kRight - 1, 40), 0);
  EXPECT_EQ(found.mask.at(kLeft - 1, 40), 0);
  EXPECT_NEAR(count(found.mask), kPersonPixels, 4) << "a median rounds corners";
}

TEST(Silhouette, leaves_out_a_still_edge_that_is_a_pixel_off) {
  TruthView view = seen_view(still_room());
  render::fill_box(view.depth_mm, 20, 0, 21, kHeight, kShelf_mm);
  EXPECT_EQ(count(silhouette_in(view).mask), 0);
}

TEST(Silhouette, leaves_out_specks_and_what_no_sensor_sees) {
  TruthView view = view_with_person();
  view.depth_mm.at(80, 30) = kPerson_mm;
  render::fill_box<std::uint8_t>(view.seen, 0, 0, kWidth, 40, 0);
  const Silhouette found = silhouette_in(view);
  EXPECT_EQ(found.mask.at(48, 30), 0);
  EXPECT_NE(found.mask.at(48, 50), 0);
  EXPECT_NEAR(count(found.mask), kPersonPixels / 2, 4);
}

TEST(Silhouette, counts_only_for_a_sensor_that_sees_the_surface) {
  TruthView view = view_with_person();
  view.seen = MaskImage(kWidth, kHeight, 2);
  const DepthImage with_person = view.depth_mm;  // to the second sensor the person stands still
  const std::vector<StillBackground> backgrounds = {background_of(still_room()),
                                                    background_of(with_person)};
  EXPECT_EQ(count(find_silhouette(eye(), view, backgrounds).mask), 0);
}

TEST(Silhouette, reaches_30_centimetres_around_itself) {
  const Silhouette found = silhouette_in(view_with_person());
  const int reach_px = static_cast<int>(0.3 * kFocal_px / 2);
  EXPECT_FLOAT_EQ(found.reach_m.at(kRight - 1 + reach_px, 40), 2.3F);
  EXPECT_EQ(found.reach_m.at(kRight + reach_px, 40), 0);
  EXPECT_FLOAT_EQ(found.reach_m.at(48, 40), 2.3F);
}

TEST(SilhouetteErrors, of_the_truth_itself_are_none) {
  const TruthView view = view_with_person();
  const SilhouetteErrors errors = find_errors(in_metres(view.depth_mm), view, silhouette_in(view));
  EXPECT_EQ(errors.missing_share, 0);
  EXPECT_EQ(errors.doubled_share, 0);
}

TEST(SilhouetteErrors, of_a_shifted_person_are_missing_at_one_side_and_doubled_at_the_other) {
  const TruthView view = view_with_person();
  DepthImage shifted = still_room();
  render::fill_box(shifted, kLeft + 4, kTop, kRight + 4, kBottom, kPerson_mm);
  const SilhouetteErrors errors = find_errors(in_metres(shifted), view, silhouette_in(view));
  EXPECT_NE(errors.missing.at(kLeft + 1, 40), 0);
  EXPECT_EQ(errors.missing.at(kRight + 1, 40), 0);
  EXPECT_NE(errors.doubled.at(kRight + 1, 40), 0);
  EXPECT_EQ(errors.doubled.at(kLeft + 1, 40), 0);
  EXPECT_NEAR(errors.missing_share, 4.0 / 16, 0.01);
  EXPECT_NEAR(errors.doubled_share, 4.0 / 16, 0.01);
}

TEST(SilhouetteErrors, count_doubled_surfaces_also_where_no_sensor_sees_the_true_one) {
  TruthView view = view_with_person();
  const Silhouette silhouette = silhouette_in(view);
  render::fill_box<std::uint8_t>(view.seen, kRight, 0, kWidth, kHeight, 0);
  render::fill_box<std::uint16_t>(view.depth_mm, kRight, 0, kWidth, 40, 0);
  Image<float> drawn = in_metres(still_room());
  render::fill_box(drawn, kLeft, kTop, kRight + 4, kBottom, 2.0F);
  const SilhouetteErrors errors = find_errors(drawn, view, silhouette);
  EXPECT_NE(errors.doubled.at(kRight + 1, 50), 0);
  EXPECT_NE(errors.doubled.at(kRight + 1, 30), 0) << "nothing is behind at all";
}

TEST(SilhouetteErrors, holes_are_missing) {
  const TruthView view = view_with_person();
  Image<float> drawn = in_metres(view.depth_mm);
  render::fill_box(drawn, kLeft, kTop, kRight, kTop + 10, 0.0F);
  const Silhouette silhouette = silhouette_in(view);
  const SilhouetteErrors errors = find_errors(drawn, view, silhouette);
  EXPECT_NEAR(errors.missing_share, 10.0 / 40, 0.01);
  EXPECT_EQ(errors.doubled_share, 0);
  const ColorImage drawn_color(kWidth, kHeight, {100, 20, 100});
  const ColorImage picture = picture_of(errors, silhouette, drawn_color);
  EXPECT_EQ(picture.at(48, kTop + 5), (Rgb8{255, 0, 0}));
  EXPECT_EQ(picture.at(48, kBottom - 5), (Rgb8{100, 20, 100}));
  EXPECT_EQ(picture.at(80, 40), (Rgb8{94, 94, 94}));
}

TEST(SilhouetteErrors, far_from_the_person_do_not_count) {
  const TruthView view = view_with_person();
  Image<float> drawn = in_metres(view.depth_mm);
  render::fill_box(drawn, 80, 20, 90, 60, 1.0F);
  render::fill_box(drawn, 0, 20, 10, 60, 0.0F);
  const SilhouetteErrors errors = find_errors(drawn, view, silhouette_in(view));
  EXPECT_EQ(errors.missing_share, 0);
  EXPECT_EQ(errors.doubled_share, 0);
}

TEST(SilhouetteErrors, of_still_surfaces_behind_the_person_do_not_count) {
  const TruthView view = view_with_person();
  Image<float> drawn = in_metres(view.depth_mm);
  render::fill_box(drawn, kRight, kTop, kRight + 8, kBottom, 2.6F);
  EXPECT_EQ(find_errors(drawn, view, silhouette_in(view)).doubled_share, 0);
}

TEST(SilhouetteErrors, have_no_shares_without_a_silhouette) {
  const TruthView empty = seen_view(still_room());
  const SilhouetteErrors errors =
      find_errors(in_metres(empty.depth_mm), empty, silhouette_in(empty));
  EXPECT_TRUE(std::isnan(errors.missing_share));
  EXPECT_TRUE(std::isnan(errors.doubled_share));
}

}  // namespace
}  // namespace roomcast::bench
