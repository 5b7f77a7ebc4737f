// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/pose_verification.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

using alignment::StoredPoseCheck;
using alignment::StoredPoseVerdict;

RigidTransform stored_at(double x) {
  RigidTransform pose;
  pose.translation_m = {x, 1, 0};
  return pose;
}

/// Simulates sensors stored_at these positions: their surfaces overlap when they are a metre apart
/// stored_at most.
PosePairCheck sees(std::map<std::string, double> truth) {
  return [truth = std::move(truth)](const NamedPose& a, const NamedPose& b) -> StoredPoseCheck {
    const double apart = truth.at(b.sensor) - truth.at(a.sensor);
    const double stated = (b.world_from_depth.translation_m - a.world_from_depth.translation_m).x();
    if (std::abs(stated) > 1.5 && std::abs(apart) > 1.5) return {};
    if (std::abs(stated - apart) < 0.01)
      return {StoredPoseVerdict::kConfirmed, alignment::Contradiction::kNone, 6};
    return {StoredPoseVerdict::kContradicted, alignment::Contradiction::kShapes, 0};
  };
}

const KnownPoses kRoom = {
    {"a", stored_at(0)}, {"b", stored_at(1)}, {"c", stored_at(2)}, {"d", stored_at(3)}};

TEST(StoredPoseChecks, a_whole_room_confirms_itself) {
  const auto checks =
      verify_stored_poses(kRoom, {}, sees({{"a", 0}, {"b", 1}, {"c", 2}, {"d", 3}}));
  EXPECT_EQ(checks.confirmed.size(), 4U);
  EXPECT_TRUE(checks.inconclusive.empty());
  EXPECT_TRUE(checks.contradicted.empty());
  EXPECT_EQ(checks.confirmed.at("c").pose.world_from_depth.translation_m,
            stored_at(2).translation_m);
  EXPECT_EQ(checks.confirmed.at("c").pose.expected_error_mm, 6);
}

TEST(StoredPoseChecks, the_one_that_was_moved_is_found_out_by_the_others) {
  const auto checks =
      verify_stored_poses(kRoom, {}, sees({{"a", 0.5}, {"b", 1}, {"c", 2}, {"d", 3}}));
  EXPECT_EQ(checks.confirmed.size(), 3U);
  ASSERT_TRUE(checks.contradicted.contains("a"));
  EXPECT_TRUE(checks.contradicted.at("a").withdrawn);
  EXPECT_FALSE(checks.contradicted.at("a").pose.is_placed());
  EXPECT_NE(checks.contradicted.at("a").pose.note.find("those of b"), std::string::npos);
}

TEST(StoredPoseChecks, one_alone_has_nothing_to_be_compared_with) {
  const auto checks = verify_stored_poses({{"a", stored_at(0)}}, {}, sees({{"a", 0}}));
  EXPECT_TRUE(checks.inconclusive.contains("a"));
  EXPECT_TRUE(checks.confirmed.empty() && checks.contradicted.empty());
}

TEST(StoredPoseChecks, of_two_that_disagree_nobody_knows_which_was_moved) {
  const auto checks = verify_stored_poses({{"a", stored_at(0)}, {"b", stored_at(1)}}, {},
                                          sees({{"a", 0}, {"b", 0.5}}));
  EXPECT_EQ(checks.inconclusive.size(), 2U);
}

TEST(StoredPoseChecks, beside_one_that_is_known_the_other_is_the_one_that_was_moved) {
  const auto checks = verify_stored_poses({{"b", stored_at(1)}}, {{"a", stored_at(0)}},
                                          sees({{"a", 0}, {"b", 0.5}}));
  EXPECT_TRUE(checks.contradicted.contains("b"));
}

TEST(StoredPoseChecks, who_sees_nothing_of_the_others_stays_undecided) {
  const auto checks =
      verify_stored_poses({{"d", stored_at(3)}}, {{"a", stored_at(0)}}, sees({{"a", 0}, {"d", 3}}));
  EXPECT_TRUE(checks.inconclusive.contains("d"));
}

}  // namespace
}  // namespace roomcast::alignment
