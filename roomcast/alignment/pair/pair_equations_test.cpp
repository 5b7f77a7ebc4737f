// SPDX-License-Identifier: Apache-2.0
// Compares the Jacobians of both kinds of residual with finite differences.
#include "roomcast/alignment/pair/pair_equations.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"
#include "roomcast/alignment/pair/corrected_matches.h"
#include "roomcast/alignment/pair/feature_residuals.h"
#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/pair/pose_refinement.h"
#include "roomcast/alignment/pair/surface_residuals.h"

namespace roomcast::alignment {
namespace {

constexpr double kMillimetre = 1e-3, kMilliradian = 1e-3;

RigidTransform nudged(const RigidTransform& pose, double angle_rad, double shift_m) {
  Vector6 xi;
  xi << angle_rad, -angle_rad, angle_rad / 2, shift_m, shift_m / 2, -shift_m;
  return step_transform(xi) * pose;
}

/// Matches of the room's own surface: exact in space and in both pictures.
std::vector<PointMatch> exact_matches_of(const ViewFixture& a, const ViewFixture& b) {
  const RigidTransform a_from_b = true_pose(a, b);
  std::vector<PointMatch> matches;
  for (std::size_t i = 0; i < b.view->surface.samples.size(); i += 20) {
    const Eigen::Vector3f in_b = b.view->surface.samples[i].point_m;
    const Eigen::Vector3f in_a = (a_from_b * in_b.cast<double>()).cast<float>();
    const auto& pa = a.view->picture;
    const auto& pb = b.view->picture;
    if (pa.in_color_frame(in_a).z() < 0.5F) continue;
    matches.push_back(
        {in_a, in_b, pa.pixel_of(pa.in_color_frame(in_a)), pb.pixel_of(pb.in_color_frame(in_b))});
  }
  return matches;
}

TEST(StepTransform, turns_by_the_angle_and_shifts) {
  Vector6 xi = Vector6::Zero();
  xi(2) = 0.3;
  xi(3) = 1;
  const RigidTransform step = step_transform(xi);
  EXPECT_NEAR(difference(step, {}, {0, 0, 0}).angle_rad, 0.3, 1e-9);
  EXPECT_NEAR(step.translation_m.x(), 1, 1e-12);
  EXPECT_EQ(step_transform(Vector6::Zero()).rotation, Eigen::Matrix3d::Identity());
}

TEST(SolveMotion, stands_still_where_nothing_holds) {
  EXPECT_EQ(solve_motion(PairEquations{}), Vector6::Zero());
}

TEST(RobustWeight, lets_outliers_fade) {
  EXPECT_EQ(robust_weight(0), 1);
  EXPECT_LT(robust_weight(10), 0.01);
}

TEST(SurfaceEquations, lead_back_to_the_true_pose) {
  const auto& a = first_corner();
  const auto b =
      view_fixture({}, "beside", world_from_optical_looking_at({1.2, 1.9, 1.6}, {-0.3, 0.4, -0.3}));
  PairState state{nudged(true_pose(a, b), 0.01, 0.02), {}, {}};
  for (int i = 0; i < 12; ++i) {
    const auto partners =
        surface_partners(a.view->surface, b.view->surface, state.a_from_b, {0.08F, 4000});
    state.a_from_b = step_transform(solve_motion(surface_equations(partners, state.a_from_b, 1))) *
                     state.a_from_b;
  }
  const PoseDifference left = difference(state.a_from_b, true_pose(a, b));
  EXPECT_LT(left.angle_rad, 2 * kMilliradian);
  EXPECT_LT(left.distance_m, 5 * kMillimetre);
}

/// A measured point with its depth corrected by (offset, scale).
Eigen::Vector3d with_depth(const Eigen::Vector3f& point_m, const Eigen::Vector2d& depth) {
  const Eigen::Vector3d point = point_m.cast<double>();
  return (1 + depth(1) + depth(0) / point.z()) * point;
}

TEST(SurfaceEquations, gradient_is_that_of_the_distances) {
  const auto& a = first_corner().view->surface;
  const auto& b = second_corner().view->surface;
  const RigidTransform pose = nudged(true_pose(first_corner(), second_corner()), 0.002, 0.003);
  constexpr double kTrusting = 1e4;
  const auto partners = surface_partners(a, b, pose, {0.1F, 1000});
  const auto equations = surface_equations(partners, pose, kTrusting);
  const double share = 1500.0 / std::max<double>(1500, double(partners.size()));
  const auto cost = [&](const PairVector& at) {
    const RigidTransform moved = step_transform(at.head<6>()) * pose;
    double sum = 0;
    for (const SurfacePartner& p : partners) {
      const Eigen::Vector3d apart = moved * with_depth(p.b_m, at.segment<2>(kOfB + kDepth)) -
                                    with_depth(p.a_m, at.segment<2>(kOfA + kDepth));
      const double residual = p.normal.cast<double>().dot(apart);
      sum += residual * residual / double(p.variance_m2);
    }
    return sum;
  };
  for (Eigen::Index i = 0; i < kPairUnknowns; ++i) {
    const PairVector step = 1e-4 * PairVector::Unit(i);
    const double numeric = (cost(step) - cost(-step)) / 4e-4;
    const double analytic = equations.gradient(i) * kTrusting * kTrusting / share;
    EXPECT_NEAR(analytic, numeric, 0.02 * std::abs(numeric) + 20) << "unknown " << i;
  }
}

TEST(SurfacePartners, lie_near_each_other_at_the_truth_and_apart_beside_it) {
  const auto& a = first_corner().view->surface;
  const auto& b = second_corner().view->surface;
  const RigidTransform truth = true_pose(first_corner(), second_corner());
  const auto noise_at = [&](const RigidTransform& pose) {
    return surface_noise(surface_partners(a, b, pose, {0.05F, 4000}));
  };
  EXPECT_LT(noise_at(truth), 0.5);
  EXPECT_GT(noise_at(nudged(truth, 0.01, 0.02)), 2 * noise_at(truth));
  RigidTransform nowhere = truth;
  nowhere.translation_m.y() += 50;
  EXPECT_TRUE(surface_partners(a, b, nowhere, {}).empty());
}

TEST(FeatureEquations, lead_back_to_the_true_pose_in_few_steps) {
  const auto& a = first_corner();
  const auto& b = second_corner();
  const auto matches = exact_matches_of(a, b);
  PairState state{nudged(true_pose(a, b), 0.01, 0.01), {}, {}};
  for (int i = 0; i < 10; ++i) {
    const auto equations = feature_equations(a.view->picture, b.view->picture, state, matches, {5});
    state.a_from_b = step_transform(solve_motion(equations)) * state.a_from_b;
  }
  const PoseDifference left = difference(state.a_from_b, true_pose(a, b));
  EXPECT_LT(left.angle_rad, 0.01 * kMilliradian);
  EXPECT_LT(left.distance_m, 0.01 * kMillimetre);
}

/// The sum of squares whose gradient the equations give, as long as there are no outliers.
double cost(const ViewFixture& a, const ViewFixture& b, const PairState& state,
            const std::vector<PointMatch>& matches, const Eigen::Vector2d& depth_a,
            const Eigen::Vector2d& depth_b) {
  double sum = 0;
  for (const PointMatch& match : matches) {
    const auto shifted = [](const ColorPicture& picture, const Eigen::Vector3f& point,
                            const SensorCorrection& correction, const Eigen::Vector2d& depth) {
      const Eigen::Vector3f in_color = picture.in_color_frame(point);
      const Eigen::Vector2f shift = correction.color_shift_px.cast<float>();
      const Eigen::Vector3f moved(in_color.x() + in_color.z() * shift.x() / picture.camera.fx,
                                  in_color.y() + in_color.z() * shift.y() / picture.camera.fy,
                                  in_color.z());
      const Eigen::Vector3f lifted =
          picture.color_from_depth_rotation.transpose() * (moved - picture.color_from_depth_m);
      return Eigen::Vector3f(lifted + with_depth(point, depth).cast<float>() - point);
    };
    const auto add = [&](const ColorPicture& into, const RigidTransform& into_from_from,
                         const Eigen::Vector3f& point, const Eigen::Vector2f& seen,
                         const SensorCorrection& correction) {
      const Eigen::Vector3f there = (into_from_from * point.cast<double>()).cast<float>();
      const Eigen::Vector2d residual =
          (into.pixel_of(into.in_color_frame(there)) - seen).cast<double>() -
          correction.color_shift_px;
      sum += residual.squaredNorm();
    };
    add(a.view->picture, state.a_from_b, shifted(b.view->picture, match.b_m, state.b, depth_b),
        match.a_pixel, state.a);
    add(b.view->picture, state.a_from_b.inverse(),
        shifted(a.view->picture, match.a_m, state.a, depth_a), match.b_pixel, state.b);
  }
  return sum;
}

TEST(FeatureEquations, gradient_is_that_of_the_reprojection_error) {
  const auto& a = first_corner();
  const auto& b = second_corner();
  auto matches = exact_matches_of(a, b);
  matches.resize(10);
  PairState state{nudged(true_pose(a, b), 0.003, 0.004), {}, {}};
  state.a.color_shift_px = {0.8, -0.5};
  state.b.color_shift_px = {-0.4, 0.6};
  constexpr double kTrusting_px = 1e3;
  const auto equations =
      feature_equations(a.view->picture, b.view->picture, state, matches, {kTrusting_px});
  ASSERT_EQ(equations.terms, 40);
  const auto moved = [&](Eigen::Index unknown, double by) {
    const PairVector step = by * PairVector::Unit(unknown);
    PairState at = state;
    at.a_from_b = step_transform(step.head<6>()) * at.a_from_b;
    at.a.color_shift_px += step.segment<2>(kOfA + kShift);
    at.b.color_shift_px += step.segment<2>(kOfB + kShift);
    return cost(a, b, at, matches, step.segment<2>(kOfA + kDepth), step.segment<2>(kOfB + kDepth));
  };
  for (Eigen::Index i = 0; i < kPairUnknowns; ++i) {
    const bool in_px = (i >= kOfA && i < kOfA + kDepth) || (i >= kOfB && i < kOfB + kDepth);
    const double step = in_px ? 0.1 : 1e-3;
    const double numeric = (moved(i, step) - moved(i, -step)) / (4 * step);
    const double analytic = equations.gradient(i) * kTrusting_px * kTrusting_px;
    EXPECT_NEAR(analytic, numeric, 0.02 * std::abs(numeric) + 1) << "unknown " << i;
  }
}

TEST(FeatureSigma, is_that_of_the_noise_within_reason) {
  const auto& a = first_corner();
  const auto& b = second_corner();
  const auto matches = exact_matches_of(a, b);
  const PairState truth{true_pose(a, b), {}, {}};
  EXPECT_NEAR(feature_sigma_px(a.view->picture, b.view->picture, truth, matches), 0.6, 1e-6);
  EXPECT_NEAR(feature_sigma_px(a.view->picture, b.view->picture, truth, {}), 3, 1e-6);
}

TEST(Settling, brings_a_hypothesis_to_where_surfaces_and_features_agree) {
  const auto& a = first_corner();
  const auto& b = second_corner();
  const RigidTransform start = nudged(true_pose(a, b), 0.015, 0.03);
  const RigidTransform settled =
      refined_pose(*a.view, *b.view, exact_matches_of(a, b), start).a_from_b;
  EXPECT_LT(difference(settled, true_pose(a, b)).distance_m, 5 * kMillimetre);
}

/// Matches where b's colour picture is `right_px` to the right of its depth.
std::vector<PointMatch> matches_with_color_aside(const ViewFixture& a, const ViewFixture& b,
                                                 float right_px) {
  const PairState state{true_pose(a, b), {}, {Eigen::Vector2d(double(right_px), 0)}};
  auto matches = corrected_matches(exact_matches_of(a, b), a.view->picture, b.view->picture, state);
  for (PointMatch& match : matches) match.b_pixel.x() += right_px;
  return matches;
}

TEST(Settling, finds_colour_that_lies_aside_where_it_is_asked_to) {
  const auto& a = first_corner();
  const auto& b = second_corner();
  constexpr float kAside_px = 12;
  const auto matches = matches_with_color_aside(a, b, kAside_px);
  const PairState found =
      refined_pose(*a.view, *b.view, matches, true_pose(a, b), ColorCalibration::kUncertain);
  // The features' sigma of two pixels is about a centimetre.
  EXPECT_LT(difference(found.a_from_b, true_pose(a, b)).distance_m, 10 * kMillimetre);
  EXPECT_NEAR(found.b.color_shift_px.x(), -double(kAside_px), 3);
  const PairState believed = refined_pose(*a.view, *b.view, matches, true_pose(a, b));
  EXPECT_TRUE(believed.b.color_shift_px.isZero());
}

}  // namespace
}  // namespace roomcast::alignment
