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
    const double said = (b.world_from_depth.translation_m - a.world_from_depth.translation_m).x();
    if (std::abs(said) > 1.5 && std::abs(apart) > 1.5) return {};
    if (std::abs(said - apart) < 0.01)
      return {StoredPoseVerdict::kConfirmed, alignment::Contradiction::kNone, 6};
    return {StoredPoseVerdict::kContradicted, alignment::Contradiction::kShapes, 0};
  };
}

const KnownPoses kRoom = {
    {"a", stored_at(0)}, {"b", stored_at(1)}, {"c", stored_at(2)}, {"d", stored_at(3)}};

TEST(StoredPoseChecks, a_whole_room_confirms_itself) {
  const auto told = verify_stored_poses(kRoom, {}, sees({{"a", 0}, {"b", 1}, {"c", 2}, {"d", 3}}));
  EXPECT_EQ(told.confirmed.size(), 4U);
  EXPECT_TRUE(told.untold.empty());
  EXPECT_TRUE(told.contradicted.empty());
  EXPECT_EQ(told.confirmed.at("c").world_from_depth->translation_m, stored_at(2).translation_m);
  EXPECT_EQ(told.confirmed.at("c").expected_error_mm, 6);
}

TEST(StoredPoseChecks, the_one_that_was_moved_is_found_out_by_the_others) {
  const auto told =
      verify_stored_poses(kRoom, {}, sees({{"a", 0.5}, {"b", 1}, {"c", 2}, {"d", 3}}));
  EXPECT_EQ(told.confirmed.size(), 3U);
  ASSERT_TRUE(told.contradicted.contains("a"));
  EXPECT_TRUE(told.contradicted.at("a").withdrawn);
  EXPECT_FALSE(told.contradicted.at("a").world_from_depth);
  EXPECT_NE(told.contradicted.at("a").note.find("b sees"), std::string::npos);
}

TEST(StoredPoseChecks, one_alone_has_nothing_to_be_compared_with) {
  const auto told = verify_stored_poses({{"a", stored_at(0)}}, {}, sees({{"a", 0}}));
  EXPECT_TRUE(told.untold.contains("a"));
  EXPECT_TRUE(told.confirmed.empty() && told.contradicted.empty());
}

TEST(StoredPoseChecks, of_two_that_disagree_nobody_knows_which_was_moved) {
  const auto told = verify_stored_poses({{"a", stored_at(0)}, {"b", stored_at(1)}}, {},
                                        sees({{"a", 0}, {"b", 0.5}}));
  EXPECT_EQ(told.untold.size(), 2U);
}

TEST(StoredPoseChecks, beside_one_that_is_known_the_other_is_the_one_that_was_moved) {
  const auto told = verify_stored_poses({{"b", stored_at(1)}}, {{"a", stored_at(0)}},
                                        sees({{"a", 0}, {"b", 0.5}}));
  EXPECT_TRUE(told.contradicted.contains("b"));
}

TEST(StoredPoseChecks, who_sees_nothing_of_the_others_stays_untold) {
  const auto told =
      verify_stored_poses({{"d", stored_at(3)}}, {{"a", stored_at(0)}}, sees({{"a", 0}, {"d", 3}}));
  EXPECT_TRUE(told.untold.contains("d"));
}

}  // namespace
}  // namespace roomcast::alignment
