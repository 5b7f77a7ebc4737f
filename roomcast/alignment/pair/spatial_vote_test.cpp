// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/spatial_vote.h"

#include <random>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"
#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::alignment {
namespace {

const RigidTransform kTrueTransform =
    world_from_optical_looking_at({0.4, 1.2, -0.3}, {-1, 0.2, 0.8});
const RigidTransform kOther = world_from_optical_looking_at({2.4, 1.2, -0.3}, {1, 0.2, 0.8});

Eigen::Vector3f random_point(std::mt19937& random) {
  const auto coordinate = [&] { return static_cast<float>(random() % 3000) / 1000; };
  const float x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

void add_true(std::vector<PointMatch>& matches, const RigidTransform& a_from_b, int count,
              std::mt19937& random) {
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3f b = random_point(random);
    const Eigen::Vector3f noise = 0.01F * (random_point(random) - Eigen::Vector3f(1.5, 1.5, 1.5));
    matches.push_back({(a_from_b * b.cast<double>()).cast<float>() + noise, b, {0, 0}, {0, 0}});
  }
}

void add_false(std::vector<PointMatch>& matches, int count, std::mt19937& random) {
  for (int i = 0; i < count; ++i) {
    matches.push_back({random_point(random), random_point(random), {0, 0}, {0, 0}});
  }
}

TEST(SpatialVote, finds_the_pose_among_nine_false_matches_in_ten) {
  std::mt19937 random(3);
  std::vector<PointMatch> matches;
  add_true(matches, kTrueTransform, 30, random);
  add_false(matches, 270, random);
  const auto poses = vote_for_poses(matches);
  ASSERT_FALSE(poses.empty());
  EXPECT_LT(difference(poses[0].a_from_b, kTrueTransform).angle_rad, 0.01);
  EXPECT_LT(difference(poses[0].a_from_b, kTrueTransform).distance_m, 0.02);
}

TEST(SpatialVote, keeps_both_answers_where_two_have_support) {
  std::mt19937 random(4);
  std::vector<PointMatch> matches;
  add_true(matches, kTrueTransform, 30, random);
  add_true(matches, kOther, 20, random);
  add_false(matches, 100, random);
  const auto poses = vote_for_poses(matches);
  ASSERT_GE(poses.size(), 2u);
  EXPECT_FALSE(are_rivals(poses[0].a_from_b, kTrueTransform));
  EXPECT_FALSE(are_rivals(poses[1].a_from_b, kOther));
  EXPECT_GT(poses[0].support, poses[1].support);
}

TEST(SpatialVote, heeds_what_matches_are_worth) {
  std::mt19937 random(5);
  std::vector<PointMatch> matches;
  add_true(matches, kTrueTransform, 20, random);
  add_true(matches, kOther, 30, random);
  for (std::size_t i = 20; i < 50; ++i) matches[i].weight = 0.1F;
  EXPECT_FALSE(are_rivals(vote_for_poses(matches).at(0).a_from_b, kTrueTransform));
}

TEST(SpatialVote, gives_the_same_bits_every_time) {
  std::mt19937 random(6);
  std::vector<PointMatch> matches;
  add_true(matches, kTrueTransform, 20, random);
  add_false(matches, 100, random);
  const auto one = vote_for_poses(matches), other = vote_for_poses(matches);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].a_from_b.rotation, other[i].a_from_b.rotation);
    EXPECT_EQ(one[i].support, other[i].support);
  }
}

TEST(SpatialVote, of_too_few_or_senseless_matches_gives_nothing) {
  std::mt19937 random(7);
  std::vector<PointMatch> matches;
  EXPECT_TRUE(vote_for_poses(matches).empty());
  add_true(matches, kTrueTransform, 2, random);
  EXPECT_TRUE(vote_for_poses(matches).empty());
  matches.assign(50, matches[0]);
  EXPECT_TRUE(vote_for_poses(matches).empty());
}

}  // namespace
}  // namespace roomcast::alignment
