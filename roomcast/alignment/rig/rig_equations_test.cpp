// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/rig_equations.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::alignment {
namespace {

/// Some pose for every number, all different.
RigidTransform some_pose(int number) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, number, -2).normalized();
  return {Eigen::AngleAxisd(0.4 + 0.7 * number, axis).toRotationMatrix(),
          Eigen::Vector3d(0.5 * number, 1 - number, 0.3)};
}

RigidTransform stepped(const RigidTransform& pose, const Vector6& step) {
  return step_transform(step) * pose;
}

/// The small motion from one pose to another, in the convention of step_transform.
Vector6 motion_between(const RigidTransform& from, const RigidTransform& to) {
  const RigidTransform motion = to * from.inverse();
  const Eigen::Matrix3d twice = motion.rotation - motion.rotation.transpose();
  Vector6 step;
  step << 0.5 * twice(2, 1), 0.5 * twice(0, 2), 0.5 * twice(1, 0), motion.translation_m;
  return step;
}

TEST(PairFromSensors, is_the_derivative_of_the_pairs_motion_by_the_sensors_motions) {
  const RigidTransform a = some_pose(1), b = some_pose(2);
  const auto carry = pair_from_sensors(a);
  constexpr double kStep = 1e-6;  // errors of the second order are some 1e-6 of a difference
  for (Eigen::Index i = 0; i < 6; ++i) {
    const Vector6 step = kStep * Vector6::Unit(i);
    const Vector6 by_a = motion_between(a.inverse() * b, stepped(a, step).inverse() * b) / kStep;
    const Vector6 by_b = motion_between(a.inverse() * b, a.inverse() * stepped(b, step)) / kStep;
    EXPECT_LT((carry.block<6, 1>(kMotion, i) - by_a).norm(), 1e-4) << i;
    EXPECT_LT((carry.block<6, 1>(kMotion, kSensorUnknowns + i) - by_b).norm(), 1e-4) << i;
  }
}

TEST(PairFromSensors, corrections_are_the_sensors_own) {
  const auto carry = pair_from_sensors(some_pose(1));
  Eigen::Matrix<double, 2 * kSensorUnknowns, 1> sensors =
      Eigen::Matrix<double, 2 * kSensorUnknowns, 1>::Zero();
  sensors.segment<kCorrectionUnknowns>(6) << 1, 2, 3, 4;
  sensors.segment<kCorrectionUnknowns>(kSensorUnknowns + 6) << 5, 6, 7, 8;
  const PairVector pair = carry * sensors;
  PairVector expected = PairVector::Zero();
  expected.segment<8>(kOfA) << 1, 2, 3, 4, 5, 6, 7, 8;
  EXPECT_EQ(pair, expected);
}

/// Equations of points that both sensors know exactly: at the true pose all residuals are zero.
PairEquations equations_of_points(const RigidTransform& a_from_b, const RigidTransform& truth) {
  PairEquations equations;
  for (const double x : {-1.0, 0.5, 1.5}) {
    for (const double y : {-0.7, 0.9}) {
      const Eigen::Vector3d in_b(x, y, 2 + x * y);
      const Eigen::Vector3d in_a = a_from_b * in_b, apart = in_a - truth * in_b;
      const auto by_motion = point_motion(in_a);
      for (int row = 0; row < 3; ++row) {
        PairVector jacobian = PairVector::Zero();
        jacobian.head<6>() = by_motion.row(row).transpose();
        equations.add(jacobian, apart(row), 1);
      }
    }
  }
  return equations;
}

TEST(RigEquations, lead_a_chain_of_sensors_back_to_their_poses_around_the_origin) {
  constexpr std::size_t kOrigin = 1;
  std::vector<RigidTransform> poses = {some_pose(0), some_pose(1), some_pose(2)};
  const std::vector<RigidTransform> truth = poses;
  Vector6 nudge;
  nudge << 0.02, -0.03, 0.01, 0.05, -0.02, 0.04;
  poses[0] = stepped(poses[0], nudge);
  poses[2] = stepped(poses[2], -2 * nudge);
  for (int i = 0; i < 6; ++i) {  // Gauss-Newton: the error is squared each time
    RigEquations rig(3, kOrigin);
    for (std::size_t a = 0; a < 2; ++a) {
      const PairEquations equations =
          equations_of_points(poses[a].inverse() * poses[a + 1], truth[a].inverse() * truth[a + 1]);
      rig.add(a, a + 1, poses[a], equations);
    }
    const auto steps = rig.solve();
    for (std::size_t k = 0; k < 3; ++k) poses[k] = stepped(poses[k], steps[k].head<6>());
  }
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LT(difference(poses[k], truth[k]).distance_m, 1e-9) << k;
    EXPECT_LT(difference(poses[k], truth[k]).angle_rad, 1e-9) << k;
  }
}

TEST(RigEquations, do_not_move_what_nothing_constrains) {
  RigEquations rig(3, 0);
  const Vector6 nudge = Vector6::Constant(0.01);
  rig.add(0, 1, {}, equations_of_points(stepped({}, nudge), {}));
  const auto steps = rig.solve();
  EXPECT_GT(steps[1].norm(), 0.01);
  EXPECT_TRUE(steps[2].isZero());
  EXPECT_LT(steps[0].norm(), 1e-10);  // the origin is held
  for (const auto& step : RigEquations(2, 0).solve()) EXPECT_TRUE(step.isZero());
}

TEST(RigEquations, the_prior_draws_colour_shifts_to_zero) {
  RigEquations rig(2, 0);
  SensorCorrection correction;
  correction.color_shift_px = {3, -2};
  rig.add_prior(1, correction);
  const auto steps = rig.solve();
  EXPECT_LT((steps[1].segment<2>(6 + kShift) + correction.color_shift_px).norm(), 1e-6);
  EXPECT_TRUE(steps[0].isZero());
}

TEST(RigEquations, the_prior_yields_to_observations_the_sooner_the_larger_the_shift) {
  const auto drawn = [](double shift_px) {
    PairEquations seen;  // 1 / px^2 for the present shift of b
    seen.information(kOfB + kShift, kOfB + kShift) = 1;
    SensorCorrection correction;
    correction.color_shift_px.x() = shift_px;
    RigEquations rig(2, 0);
    rig.add(0, 1, {}, seen);
    rig.add_prior(1, correction);
    return -rig.solve()[1](6 + kShift) / shift_px;
  };
  // The prior's weight is 1 / (0.7^2 + shift^2); its share of both weights is drawn back.
  EXPECT_NEAR(drawn(1), (1 / 1.49) / (1 / 1.49 + 1), 1e-6);
  EXPECT_NEAR(drawn(10), (1 / 100.49) / (1 / 100.49 + 1), 1e-6);
}

/// A pair whose motion is known to 1 / information, and whose shift along z depends on depth scale.
PairEquations known_motion(double information, double by_depth_scale = 0) {
  PairEquations equations;
  equations.information.topLeftCorner<6, 6>() = information * Matrix6::Identity();
  constexpr Eigen::Index kScaleOfB = kOfB + kDepth + 1;
  equations.information(5, kScaleOfB) = equations.information(kScaleOfB, 5) = by_depth_scale;
  return equations;
}

TEST(RigCovariance, is_the_inverse_of_the_information) {
  RigEquations rig(3, 0);
  rig.add(0, 1, {}, known_motion(400));
  const auto covariance = rig.motion_covariance(RigScatter(3), {0, 0, 0});
  EXPECT_EQ(covariance[0], Matrix6::Zero());
  EXPECT_LT((covariance[1] - Matrix6::Identity() / 400).norm(), 1e-6 / 400);
  EXPECT_TRUE(covariance[2].isZero());
}

TEST(RigCovariance, grows_with_what_depth_may_be_wrong_by) {
  constexpr double kInformation = 1e6, kByScale = 2e6;
  RigEquations rig(2, 0);
  rig.add(0, 1, {}, known_motion(kInformation, kByScale));
  const DepthUncertainty doubt{0, 0.003, 0.004};
  const Matrix6 covariance = rig.motion_covariance(RigScatter(2), doubt)[1];
  // A scale too large by s shifts the sensor by s * kByScale / kInformation. Its own and the common
  // scale are independent.
  const double by_depth = (0.003 * 0.003 + 0.004 * 0.004) * 4;
  EXPECT_NEAR(covariance(5, 5), 1 / kInformation + by_depth, 1e-4 * by_depth);
  EXPECT_NEAR(covariance(4, 4), 1 / kInformation, 1e-6 / kInformation);
}

}  // namespace
}  // namespace roomcast::alignment
