// SPDX-License-Identifier: Apache-2.0
#include "bench/model/model_score.h"

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

const CameraIntrinsics kScoreLens = {
    .width = 40, .height = 30, .fx = 40, .fy = 40, .cx = 19.5, .cy = 14.5};
constexpr std::size_t kInner = 38 * 28;  // the outermost pixels have no normal

StillTruth wall() {
  return {kScoreLens, {}, DepthImage(40, 30, 2000), MaskImage(40, 30, 255)};
}

ScoreFigures figures(float model_m, const StillTruth& truth = wall()) {
  SurfaceScore score;
  add_score(Image<float>(40, 30, model_m), truth, score);
  return figures_of(score);
}

TEST(ModelScore, errors_are_distances_from_the_surface) {
  const auto score = figures(2.01F);
  EXPECT_NEAR(score.median_mm, 10, 0.01);
  EXPECT_NEAR(score.p90_mm, 10, 0.01);
  EXPECT_EQ(score.coverage, 1);
  EXPECT_EQ(score.floating, 0);
  EXPECT_EQ(score.pixels, kInner);
}

TEST(ModelScore, a_surface_elsewhere_covers_nothing) {
  EXPECT_EQ(figures(2.05F).coverage, 0);
  EXPECT_EQ(figures(2.05F).floating, 0);
}

TEST(ModelScore, what_floats_in_front_is_told) {
  EXPECT_EQ(figures(1.85F).floating, 1);
}

TEST(ModelScore, no_model_covers_nothing) {
  const auto score = figures(0);
  EXPECT_EQ(score.coverage, 0);
  EXPECT_EQ(score.median_mm, 0);
}

TEST(ModelScore, what_nobody_saw_does_not_count) {
  StillTruth truth = wall();
  truth.readings = MaskImage(40, 30, 0);
  EXPECT_EQ(figures(2, truth).pixels, 0u);
  add_readings(DepthImage(40, 30, 2040), truth);
  EXPECT_EQ(figures(2, truth).pixels, 0u);
  EXPECT_EQ(figures(2, truth).coverage_once, 1);
  for (int i = 1; i < kMinReadings; ++i) add_readings(DepthImage(40, 30, 2040), truth);
  EXPECT_EQ(figures(2, truth).pixels, kInner);
}

TEST(ModelScore, a_reading_of_something_else_has_not_seen_the_surface) {
  StillTruth truth = wall();
  truth.readings = MaskImage(40, 30, 0);
  for (int i = 0; i < kMinReadings; ++i) add_readings(DepthImage(40, 30, 1500), truth);
  EXPECT_EQ(figures(2, truth).pixels, 0u);
}

}  // namespace
}  // namespace roomcast::bench
