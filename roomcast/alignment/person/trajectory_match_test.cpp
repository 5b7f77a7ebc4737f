// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/person/trajectory_match.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

using Path = std::function<Eigen::Vector3d(double time_s)>;  // of a head

// The visible surface is this much nearer than a head's centre: a centimetre less than the matcher
// expects of heads.
constexpr double kHeadRadius_m = 0.06;
constexpr double kMaxTrajectoryError_m = 0.03;  // where the walk was, from opposite sides

RigidTransform level_pose(double turn_rad, double x, double z) {
  RigidTransform pose;
  pose.rotation = Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
  pose.translation_m = {x, 0, z};
  return pose;
}

/// The sightings of a sensor 2 m above `world_from_level`'s origin, with noise.
std::vector<HeadSighting> watched(const Path& path, const RigidTransform& world_from_level,
                                  double phase_s, double seconds = 20, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 0.015);
  RigidTransform level_from_depth;
  level_from_depth.translation_m = {0, 2, 0};
  std::vector<HeadSighting> sightings;
  for (double time_s = phase_s; time_s < seconds; time_s += 0.125) {
    const Eigen::Vector3d head = world_from_level.inverse() * path(time_s);
    const Eigen::Vector3d ray = (head - level_from_depth.translation_m).normalized();
    const Eigen::Vector3d seen =
        head - kHeadRadius_m * ray + Eigen::Vector3d(noise(random), noise(random), noise(random));
    sightings.push_back(head_sighting(level_from_depth, time_s, level_from_depth.inverse() * seen));
  }
  return sightings;
}

/// Around a table at varying speed.
Eigen::Vector3d stroll(double time_s) {
  const double angle = 0.5 * time_s + 0.8 * std::sin(0.45 * time_s);
  return {1.1 * std::cos(angle), 1.7, 0.8 * std::sin(angle) + 0.2 * std::sin(2.2 * angle)};
}

const RigidTransform kHereInRoom = level_pose(0, 0, 2.5),
                     kAcrossFromHere = level_pose(3.0, 0.4, -2.4);

Result<TrajectoryMatch> match_trajectories(const Path& path, double seconds = 20) {
  return match_walks(watched(path, kHereInRoom, 0, seconds),
                     watched(path, kAcrossFromHere, 0.05, seconds, 2));
}

double error_m(const TrajectoryMatch& found) {
  const RigidTransform truth = kHereInRoom.inverse() * kAcrossFromHere;
  const Eigen::Vector3d middle = kAcrossFromHere.inverse() * Eigen::Vector3d(0, 1, 0);
  return (found.a_from_b * middle - truth * middle).norm();
}

TEST(TrajectoryMatch, opposite_sensors_are_placed_by_a_stroll) {
  const auto found = match_trajectories(stroll);
  ASSERT_TRUE(found.ok()) << found.error().message;
  EXPECT_LT(error_m(*found), kMaxTrajectoryError_m);
  EXPECT_LT(error_m(*found), 0.003 * found->expected_error_mm);
  EXPECT_GT(found->seconds, 15);
  EXPECT_NEAR(found->a_from_b.translation_m.y(), 0, 1e-12) << "floors coincide";
}

TEST(TrajectoryMatch, somebody_else_who_sits_in_one_view_does_no_harm) {
  auto a = watched(stroll, kHereInRoom, 0);
  const auto sits =
      watched([](double) { return Eigen::Vector3d(1.5, 1.7, 0.9); }, kHereInRoom, 0.0);
  a.insert(a.end(), sits.begin(), sits.end());
  std::ranges::stable_sort(a, {}, &HeadSighting::time_s);
  const auto found = match_walks(a, watched(stroll, kAcrossFromHere, 0.05, 20, 2));
  ASSERT_TRUE(found.ok()) << found.error().message;
  EXPECT_LT(error_m(*found), kMaxTrajectoryError_m);
}

TEST(TrajectoryMatch, two_walks_of_different_people_are_refused) {
  const auto other = [](double time_s) {
    return Eigen::Vector3d(1.2 * std::sin(0.9 * time_s), 1.7, 0.9 * std::cos(0.35 * time_s));
  };
  EXPECT_FALSE(match_walks(watched(stroll, kHereInRoom, 0), watched(other, kAcrossFromHere, 0.05)));
}

TEST(TrajectoryMatch, people_of_different_height_are_not_taken_for_one) {
  const auto child = [](double time_s) {
    return Eigen::Vector3d(stroll(time_s) - Eigen::Vector3d(0, 0.4, 0));
  };
  const auto found =
      match_walks(watched(stroll, kHereInRoom, 0), watched(child, kAcrossFromHere, 0.05));
  ASSERT_FALSE(found.ok());
  EXPECT_NE(found.error().message.find("no person"), std::string::npos);
}

TEST(TrajectoryMatch, a_straight_walk_at_even_pace_is_refused) {
  const auto found = match_trajectories(
      [](double time_s) { return Eigen::Vector3d(-1.5 + 0.15 * time_s, 1.7, 0.2); });
  ASSERT_FALSE(found.ok());
  EXPECT_NE(found.error().message.find("too simple"), std::string::npos);
}

TEST(TrajectoryMatch, somebody_who_stands_is_refused) {
  EXPECT_FALSE(match_trajectories([](double time_s) {
    return Eigen::Vector3d(0.05 * std::sin(time_s), 1.7, 0.05 * std::cos(1.7 * time_s));
  }));
}

TEST(TrajectoryMatch, a_moment_is_not_enough) {
  EXPECT_FALSE(match_trajectories(stroll, 2));
  EXPECT_FALSE(match_walks({}, {}));
}

}  // namespace
}  // namespace roomcast::alignment
