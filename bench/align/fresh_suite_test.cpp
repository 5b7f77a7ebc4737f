// SPDX-License-Identifier: Apache-2.0
#include "bench/align/fresh_suite.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/alignment/feature/views_fixture.h"

namespace roomcast::bench {
namespace {

SimulatedView seen(const alignment::ViewFixture& view) {
  return {view.view, view.world_from_depth};
}

/// Two sensors of one room, and one of a room that looks different.
FreshSuite align_two_and_a_stranger() {
  alignment::RoomFixture elsewhere;
  elsewhere.looks = 7;
  const auto stranger = alignment::view_fixture(elsewhere, "far", alignment::corner_pose(-2, 1.5));
  FreshSuite suite;
  suite.add({"fixture",
             {seen(alignment::first_corner()), seen(alignment::second_corner()), {nullptr, {}}},
             {seen(stranger)}});
  return suite;
}

const FreshSuite& two_and_a_stranger() {
  static const FreshSuite suite = align_two_and_a_stranger();
  return suite;
}

TEST(FreshSuite, counts_pairs_with_and_without_an_answer) {
  const FreshSuite& suite = two_and_a_stranger();
  EXPECT_EQ(suite.pairs(), 3);
  const auto rows = suite.rows();
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].right, 1);
  EXPECT_EQ(rows[1].overlap, "none");
  EXPECT_EQ(rows[1].pairs, 2);
  EXPECT_EQ(rows[1].right, 2);
  EXPECT_EQ(rows[1].accepted_wrong, 0);
  EXPECT_EQ(suite.sharing(), 1);
  EXPECT_EQ(suite.sharing_answered(), 1);
}

TEST(FreshSuite, counts_sufficient_overlaps_by_scene) {
  const auto scenes = two_and_a_stranger().scenes();
  ASSERT_EQ(scenes.size(), 2u);
  EXPECT_EQ(scenes[0].scene, "fixture");
  EXPECT_EQ(scenes[0].right, 1);
  EXPECT_EQ(scenes[1].overlap, "none");
  EXPECT_EQ(scenes[1].refused, 2);
}

TEST(FreshSuite, sensors_of_one_other_room_are_held_against_this_room_only) {
  const SimulatedView here = seen(alignment::first_corner());
  FreshSuite suite;
  suite.add(
      {"fixture", {here}, {seen(alignment::one_side()), seen(alignment::other_side())}, true});
  EXPECT_EQ(suite.pairs(), 2);
  ASSERT_EQ(suite.rows().size(), 1u);
  EXPECT_EQ(suite.rows()[0].overlap, "alike");
  EXPECT_EQ(suite.rows()[0].right, 2);
}

TEST(FreshSuite, judges_expected_errors) {
  const FreshSuite& suite = two_and_a_stranger();
  for (const ErrorRatios* ratios : {&suite.distance_ratios(), &suite.angle_ratios()}) {
    ASSERT_EQ(ratios->ratios.size(), 1u);
    EXPECT_GT(ratios->ratios[0], 0);
    EXPECT_EQ(ratios->within_twice(), 1) << "without noise nothing is worse than expected";
  }
}

TEST(ErrorRatios, count_those_within_twice) {
  EXPECT_EQ((ErrorRatios{{0.5, 2, 2.1, 9}}).within_twice(), 0.5);
  EXPECT_EQ(ErrorRatios{}.within_twice(), 0);
}

TEST(FreshSuite, reports_as_json_and_as_a_table) {
  std::ostringstream json, table;
  print_json(two_and_a_stranger(), json);
  print_table(two_and_a_stranger(), table);
  EXPECT_EQ(nlohmann::json::parse(json.str())["pairs"], 3);
  EXPECT_EQ(nlohmann::json::parse(json.str())["scenes"][0]["scene"], "fixture");
  EXPECT_THAT(table.str(), testing::HasSubstr("3 pairs in 1 rooms"));
  EXPECT_THAT(table.str(), testing::HasSubstr("fixture"));
}

}  // namespace
}  // namespace roomcast::bench
