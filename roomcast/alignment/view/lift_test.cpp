// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/lift.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"
#include "roomcast/alignment/view/seen_corner_fixture.h"

namespace roomcast::alignment {
namespace {

TEST(Lift, lifts_a_pixel_to_the_surface_that_is_seen_there) {
  const Seen seen;
  int lifted = 0, on_surface = 0;
  for (int y = 20; y < 280; y += 13) {
    for (int x = 20; x < 380; x += 13) {
      const auto point = lift(seen.picture, seen.surface, {x, y});
      if (!point) continue;
      ++lifted;
      const Eigen::Vector3d at = kPose * point->cast<double>();
      on_surface +=
          std::abs(cast_ray({}, kPose.translation_m, at - kPose.translation_m) - 1) < 0.01;
    }
  }
  EXPECT_GT(lifted, 250);
  EXPECT_GT(on_surface, 0.95 * lifted) << "the rest lies at edges that 3x3 pixels do not show";
}

TEST(Lift, lifts_nothing_outside_or_without_depth) {
  Seen seen;
  EXPECT_FALSE(lift(seen.picture, seen.surface, {-5, 10}).has_value());
  EXPECT_FALSE(lift(seen.picture, seen.surface, {1e6F, 10}).has_value());
  seen.picture.z_m = Image<float>(seen.picture.z_m.width(), seen.picture.z_m.height());
  EXPECT_FALSE(lift(seen.picture, seen.surface, {200, 150}).has_value());
}

/// Errors of lifted points along their rays, mm, ascending; positive = too far.
std::vector<double> too_far_mm(const Seen& seen) {
  const SensorCalibration& calibration = seen.bundle.calibration;
  const RigidTransform world_from_color = kPose * calibration.color_from_depth.inverse();
  std::vector<double> errors_mm;
  for (int y = 10; y < 290; y += 7) {
    for (int x = 10; x < 390; x += 7) {
      const auto point = lift(seen.picture, seen.surface, {x, y});
      if (!point) continue;
      const Eigen::Vector3d in_color = calibration.color_from_depth * point->cast<double>();
      const Eigen::Vector3d ray = world_from_color.rotation * (in_color / in_color.z());
      errors_mm.push_back(1000 *
                          (in_color.z() - cast_ray({}, world_from_color.translation_m, ray)));
    }
  }
  std::sort(errors_mm.begin(), errors_mm.end());
  return errors_mm;
}

TEST(Lift, is_exact_on_surfaces_that_are_seen_aslant) {
  const auto errors_mm = too_far_mm(Seen());
  ASSERT_GT(errors_mm.size(), 1000u);
  constexpr double kReadings_mm = 1;  // depth readings are whole millimetres
  EXPECT_NEAR(errors_mm[errors_mm.size() / 2], 0, kReadings_mm / 2);
  EXPECT_GT(errors_mm[errors_mm.size() / 5], -kReadings_mm);
  EXPECT_LT(errors_mm[errors_mm.size() * 4 / 5], kReadings_mm);
}

}  // namespace
}  // namespace roomcast::alignment
