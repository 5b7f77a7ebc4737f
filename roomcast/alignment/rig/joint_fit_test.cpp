// SPDX-License-Identifier: Apache-2.0
// A room through which a box walks, seen by two sensors with exact readings, one of them perhaps in
// need of a factor.
#include "roomcast/alignment/rig/joint_fit.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/walk_views_fixture.h"
#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::alignment {
namespace {

const RigidTransform kFirst = corner_pose(2, 1.5), kSecond = corner_pose(2, -1.5);
const std::array<double, 2> kPriors = {0, 0.03};

struct TwoViews {
  std::shared_ptr<const SensorView> a, b;
  PairCandidates candidates;
  std::array<RigPair, 1> pairs;

  explicit TwoViews(double scale_of_b)
      : a(walk_view({}, "a", kFirst)),
        b(walk_view({}, "b", kSecond, scale_of_b)),
        candidates(*a, *b, {}),
        pairs{{{0, 1, &candidates}}} {}
};

JointFit fit_of(const TwoViews& views, ScaleFit scales, const RigidTransform& start) {
  return fit_jointly(JointTerms(2, views.pairs), {{{}, 1}, {start, 1}}, 0, scales, kPriors);
}

RigidTransform start_pose() {
  return kFirst.inverse() * alignment::beside(kSecond, {0.03, -0.02, 0.02}, 0.01);
}

TEST(JointFit, finds_the_pose_within_its_error) {
  const JointFit fit = fit_of(TwoViews(1), ScaleFit::kFixed, start_pose());
  const auto error = difference(fit.sensors[1].origin_from_sensor, kFirst.inverse() * kSecond,
                                Eigen::Vector3d(0, 0, 2.5));
  const auto by_motion =
      point_motion(fit.sensors[1].origin_from_sensor * Eigen::Vector3d(0, 0, 2.5));
  const double said_m = std::sqrt((by_motion * fit.covariance[1] * by_motion.transpose()).trace());
  EXPECT_LT(error.distance_m, 0.05);  // the box's edges are matched across its corners
  EXPECT_LT(error.distance_m, 2 * said_m);
  EXPECT_LT(said_m, 0.2);
  EXPECT_NEAR(fit.sensors[1].scale, 1, 1e-9);
  EXPECT_EQ(fit.scale_sigma[1], 0);
  EXPECT_GT(fit.instants[0], 4u);
  EXPECT_TRUE(fit.covariance[0].isZero());
  EXPECT_GT(fit.covariance[1].trace(), 0);
}

TEST(JointFit, the_scale_is_found_within_its_error) {
  const JointFit fit = fit_of(TwoViews(1.04), ScaleFit::kFree, start_pose());
  EXPECT_NEAR(fit.sensors[0].scale, 1, 1e-9);
  EXPECT_EQ(fit.scale_sigma[0], 0);
  EXPECT_NEAR(fit.sensors[1].scale, 1.04, 0.02);
  EXPECT_GT(fit.scale_sigma[1], 0.002);  // nominal lenses leave it open
  EXPECT_LT(std::abs(fit.sensors[1].scale - 1.04), 2 * fit.scale_sigma[1]);
}

TEST(JointFit, doubted_lenses_make_errors_larger) {
  const TwoViews views(1);
  JointFitOptions exact;
  exact.focal_sigma = 1e-5;
  exact.center_sigma_px = 0.01;
  const JointTerms terms(2, views.pairs);
  const std::vector<ScaledPose> start = {{{}, 1}, {start_pose(), 1}};
  const double doubted =
      fit_jointly(terms, start, 0, ScaleFit::kFixed, kPriors).covariance[1].trace();
  const double sure =
      fit_jointly(terms, start, 0, ScaleFit::kFixed, kPriors, exact).covariance[1].trace();
  EXPECT_GT(doubted, 1.2 * sure);
}

TEST(JointFit, errors_do_not_contain_the_common_scale) {
  const TwoViews views(1);
  const JointTerms terms(2, views.pairs);
  const std::vector<ScaledPose> start = {{{}, 1}, {start_pose(), 1}};
  const auto error = [&](double sigma) {
    const std::array<double, 2> priors = {sigma, sigma};
    return fit_jointly(terms, start, 0, ScaleFit::kFixed, priors).covariance[1].trace();
  };
  // The baseline of 3 m alone would be off by 0.9 m if all scales were off by 30 %.
  const double by_scales = error(0.3) - error(1e-4);
  EXPECT_GT(by_scales, 0);
  EXPECT_LT(by_scales, 0.5 * 0.9 * 0.9);
}

/// The view of a sensor whose readings are off by up to 15 mm, here more and there less.
std::shared_ptr<const SensorView> with_ripples(const SensorView& view) {
  CalibrationBundle bundle = *view.bundle;
  for (int y = 0; y < bundle.depth_mm.height(); ++y) {
    for (int x = 0; x < bundle.depth_mm.width(); ++x) {
      std::uint16_t& depth_mm = bundle.depth_mm.at(x, y);
      if (depth_mm > 0)
        depth_mm = static_cast<std::uint16_t>(depth_mm + std::lround(15 * std::sin(0.15 * x)));
    }
  }
  auto rippled = make_sensor_view(bundle);
  ROOMCAST_ASSERT(rippled.ok());
  return std::make_shared<const SensorView>(std::move(*rippled));
}

TEST(JointFit, surfaces_that_disagree_do_not_make_scales_smaller) {
  const auto a = walk_view({}, "a", kFirst);
  const auto b = with_ripples(*walk_view({}, "b", kSecond));
  const PairCandidates candidates(*a, *b, {});
  const std::array<RigPair, 1> pairs = {{{0, 1, &candidates}}};
  const std::array<double, 2> free = {0.03, 0.03};
  const JointFit fit =
      fit_jointly(JointTerms(2, pairs), {{{}, 1}, {start_pose(), 1}}, 0, ScaleFit::kFree, free);
  EXPECT_NEAR(std::sqrt(fit.sensors[0].scale * fit.sensors[1].scale), 1, 1e-3);
}

}  // namespace
}  // namespace roomcast::alignment
