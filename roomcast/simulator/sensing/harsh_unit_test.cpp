// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/harsh_unit.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

SensorUnit unit_of(Harshness harshness, int index, std::uint64_t seed = 1) {
  SensingOptions options;
  options.harsh = harshness;
  options.half_color = true;
  return make_unit(options, seed, index);
}

TEST(HarshUnit, declares_the_nominal_lens_which_all_units_of_a_model_share) {
  const CameraIntrinsics nominal = profile_of(CameraModel::kKinect1, true).nominal.depth;
  for (int index = 0; index < 8; ++index) {
    const SensorUnit unit = unit_of(Harshness::kStructuredLight, index);
    EXPECT_EQ(unit.reported.depth, nominal);
    EXPECT_NE(unit.exact.depth.fx, nominal.fx);
    EXPECT_NEAR(unit.exact.depth.fx / nominal.fx, 1, 0.0301);
    EXPECT_NEAR(unit.exact.depth.cx, nominal.cx, 8.01);
  }
}

TEST(HarshUnit, draws_scales_and_lenses_up_to_their_limits) {
  double widest_scale = 0, widest_focal = 0;
  int registered = 0;
  constexpr int kUnits = 300;
  for (std::uint64_t seed = 0; seed < kUnits; ++seed) {
    const SensorUnit unit = unit_of(Harshness::kMixed, 0, seed);
    const double scale_error = std::abs(unit.depth_scale - 1);
    EXPECT_LE(scale_error, 0.0501);
    widest_scale = std::max(widest_scale, scale_error);
    widest_focal =
        std::max(widest_focal, std::abs(unit.exact.depth.fx / unit.profile.nominal.depth.fx - 1));
    registered += unit.registered_by.has_value();
    EXPECT_EQ(unit.reported.color_is_registered, unit.registered_by.has_value());
    EXPECT_TRUE(unit.shutter.takes_time());
    EXPECT_EQ(unit.jpeg_quality, 60);
  }
  EXPECT_GT(widest_scale, 0.045);
  EXPECT_GT(widest_focal, 0.027);
  EXPECT_NEAR(registered / double{kUnits}, 1.0 / 3, 0.1);
}

TEST(HarshUnit, mixed_rigs_have_both_laws_of_depth_and_others_one) {
  std::set<DepthPrinciple> mixed;
  for (int index = 0; index < 8; ++index) {
    mixed.insert(unit_of(Harshness::kMixed, index).profile.principle);
    EXPECT_EQ(unit_of(Harshness::kTimeOfFlight, index).profile.principle,
              DepthPrinciple::kTimeOfFlight);
    EXPECT_EQ(unit_of(Harshness::kStructuredLight, index).profile.principle,
              DepthPrinciple::kStructuredLight);
  }
  EXPECT_EQ(mixed.size(), 2U);
}

TEST(HarshUnit, white_balances_differ_by_more_than_those_of_kind_units) {
  double widest = 0;
  for (int index = 0; index < 8; ++index) {
    const auto gain = unit_of(Harshness::kTimeOfFlight, index).color_gain;
    widest = std::max(widest, std::abs(static_cast<double>(gain[0] / gain[1]) - 1));
  }
  EXPECT_GT(widest, 0.08);
}

TEST(HarshUnit, is_a_function_of_seed_and_index) {
  const SensorUnit one = unit_of(Harshness::kMixed, 2, 9), again = unit_of(Harshness::kMixed, 2, 9);
  EXPECT_EQ(one.depth_scale, again.depth_scale);
  EXPECT_EQ(one.exact.depth, again.exact.depth);
  EXPECT_NE(one.depth_scale, unit_of(Harshness::kMixed, 3, 9).depth_scale);
  EXPECT_NE(one.depth_scale, unit_of(Harshness::kMixed, 2, 10).depth_scale);
}

TEST(HarshUnit, kind_units_have_none_of_it) {
  const SensorUnit unit = make_unit({}, 1, 0);
  EXPECT_EQ(unit.depth_scale, 1);
  EXPECT_FALSE(unit.shutter.takes_time());
  EXPECT_FALSE(unit.registered_by);
  EXPECT_EQ(unit.jpeg_quality, 90);
}

TEST(HarshRecording, has_3_to_30_frames_at_5_to_30_a_second) {
  std::set<int> counts;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const HarshRecording recording = draw_harsh_recording(seed);
    counts.insert(recording.frames);
    EXPECT_GE(recording.fps, 5);
    EXPECT_LE(recording.fps, 30);
  }
  EXPECT_EQ(*counts.begin(), 3);
  EXPECT_EQ(*counts.rbegin(), 30);
  EXPECT_EQ(counts.size(), 28U);
}

}  // namespace
}  // namespace roomcast::simulator
