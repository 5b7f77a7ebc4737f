// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/color_gains.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "roomcast/model/scene_fixture.h"
#include "roomcast/model/volume_mesh.h"

namespace roomcast::model {
namespace {

const std::vector<Eigen::Vector3f> kExposures = {
    {1.2F, 1.1F, 1.0F}, {0.8F, 0.9F, 0.9F}, {1.0F, 1.0F, 1.3F}};

/// Places that three views see in pairs, by their exposures, with noise.
std::vector<SharedColor> places(std::size_t count, std::size_t shining = 0) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> level(40, 160);
  std::normal_distribution<float> noise(0, 3);
  std::vector<SharedColor> shared;
  for (std::size_t i = 0; i < count; ++i) {
    for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}}) {
      const Eigen::Vector3f color(level(random), level(random), level(random));
      SharedColor place{a, b, Eigen::Vector3f::Zero(), color.cwiseProduct(kExposures[a]),
                        color.cwiseProduct(kExposures[b])};
      for (int c = 0; c < 3; ++c) place.color_b[c] += noise(random);
      if (i < shining) place.color_a = Eigen::Vector3f::Constant(230);
      shared.push_back(place);
    }
  }
  return shared;
}

void expect_one_exposure(const std::vector<Eigen::Vector3f>& gains, float tolerance) {
  for (int c = 0; c < 3; ++c) {
    const float first = gains[0][c] * kExposures[0][c];
    for (std::size_t i = 1; i < gains.size(); ++i)
      EXPECT_NEAR(gains[i][c] * kExposures[i][c] / first, 1, tolerance) << i << ", " << c;
  }
}

TEST(ColorGains, bring_all_views_to_one_exposure_also_over_a_third) {
  const auto gains = color_gains(places(2'000), 3);
  expect_one_exposure(gains, 0.01F);
  const Eigen::Vector3f product = gains[0].cwiseProduct(gains[1]).cwiseProduct(gains[2]);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(product[c], 1, 0.01) << "the room is as bright as before";
}

TEST(ColorGains, surfaces_that_shine_change_little) {
  expect_one_exposure(color_gains(places(2'000, 300), 3), 0.04F);
}

TEST(ColorGains, views_that_share_too_little_stay_as_they_are) {
  const auto gains = color_gains(places(50), 3);
  for (const Eigen::Vector3f& gain : gains) EXPECT_EQ(gain, Eigen::Vector3f::Ones());
  EXPECT_TRUE(color_gains({}, 0).empty());
}

TEST(ColorGains, are_bounded) {
  auto shared = places(1'000);
  for (SharedColor& place : shared) {
    place.color_a = Eigen::Vector3f::Constant(239);
    place.color_b = Eigen::Vector3f::Constant(17);
  }
  for (const Eigen::Vector3f& gain : color_gains(shared, 3)) {
    EXPECT_GE(gain.minCoeff(), kMinGain);
    EXPECT_LE(gain.maxCoeff(), kMaxGain);
  }
}

TEST(ColorGains, a_wall_of_two_views_has_one_color) {
  std::vector<ViewSurface> views;
  for (std::size_t i = 0; i < 2; ++i) {
    StillView view = *StillView::create(fixture_camera(), fixture_poses()[i]);
    const Rgb8 color = i == 0 ? Rgb8{100, 100, 100} : Rgb8{140, 120, 100};
    view.add(look(fixture_camera(), fixture_poses()[i], known_scene),
             ColorImage(fixture_camera().width, fixture_camera().height, color), {});
    views.emplace_back(view, ModelOptions());
  }
  RoomMesh mesh = mesh_volume(*fuse_views(views, {}));
  const auto shared = shared_colors(views, {}, {}, mesh);
  ASSERT_GT(shared.size(), 1'000u);
  color_mesh(views, color_gains(shared, views.size()), {}, {}, mesh);
  for (const Rgb8 color : mesh.colors) {
    if (color == kNoColor) continue;
    EXPECT_NEAR(color.r, 118, 2);  // the geometric mean
    EXPECT_NEAR(color.g, 110, 2);
    EXPECT_NEAR(color.b, 100, 2);
  }
}

}  // namespace
}  // namespace roomcast::model
