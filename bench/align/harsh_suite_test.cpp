// SPDX-License-Identifier: Apache-2.0
#include "bench/align/harsh_suite.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/alignment/feature/views_fixture.h"

namespace roomcast::bench {
namespace {

HarshView seen_without_error(const alignment::ViewFixture& fixture) {
  return {fixture.view, fixture.world_from_depth, 1,
          std::make_shared<const alignment::DepthSurface>(fixture.view->surface)};
}

HarshView seen_from_another_room() {
  alignment::RoomFixture elsewhere;
  elsewhere.looks = 7;
  return seen_without_error(
      alignment::view_fixture(elsewhere, "far", alignment::corner_pose(-2, 1.5)));
}

const HarshRow& row_of_two_and_a_stranger() {
  static const HarshRow row = judged({{seen_without_error(alignment::first_corner()),
                                       seen_without_error(alignment::second_corner()), HarshView{}},
                                      {seen_from_another_room()}});
  return row;
}

TEST(HarshSuite, counts_right_answers_and_refused_strangers) {
  const HarshRow& row = row_of_two_and_a_stranger();
  EXPECT_EQ(row.pairs, 1);
  EXPECT_EQ(row.answered, 1);
  EXPECT_EQ(row.wrong, 0);
  EXPECT_EQ(row.sharing, 1);
  EXPECT_EQ(row.sharing_answered, 1);
  EXPECT_EQ(row.strangers, 2);
  EXPECT_EQ(row.strangers_answered, 0);
  EXPECT_EQ(row.refused_views, 1);
  ASSERT_EQ(row.ratios.size(), 1u);
  EXPECT_EQ(row.within_twice(), 1);
}

TEST(HarshSuite, an_answer_far_from_the_truth_is_wrong_and_worse_than_said) {
  HarshView second = seen_without_error(alignment::second_corner());
  second.world_from_depth.translation_m.x() += 0.5;
  const HarshRow row = judged({{seen_without_error(alignment::first_corner()), second}, {}});
  ASSERT_EQ(row.answered, 1);
  EXPECT_EQ(row.wrong, 1);
  EXPECT_NEAR(row.errors_mm.at(0), 500, 20);
  EXPECT_EQ(row.within_twice(), 0);
}

TEST(HarshSuite, an_answer_at_another_place_is_told_from_one_that_is_not_exact) {
  HarshView second = seen_without_error(alignment::second_corner());
  second.world_from_depth.translation_m.x() += 0.2;
  EXPECT_EQ(judged({{seen_without_error(alignment::first_corner()), second}, {}}).elsewhere, 0);
  second.world_from_depth.translation_m.x() += 1;
  EXPECT_EQ(judged({{seen_without_error(alignment::first_corner()), second}, {}}).elsewhere, 1);
}

TEST(HarshSuite, a_scale_that_is_not_found_is_an_error_of_scale) {
  HarshView first = seen_without_error(alignment::first_corner());
  first.depth_scale = 1.04;
  const HarshRow row = judged({{first, seen_without_error(alignment::second_corner())}, {}});
  ASSERT_EQ(row.scale_errors.size(), 1u);
  EXPECT_NEAR(row.scale_errors[0], 1 - 1 / 1.04, 0.02);
}

TEST(HarshSuite, sums_rows_of_a_part_only) {
  HarshRow one, two, other;
  one.part = two.part = "judged";
  other.part = "development";
  one.pairs = 3;
  one.errors_mm = {1, 2};
  two.pairs = 4;
  two.errors_mm = {3};
  other.pairs = 100;
  const HarshRow sum = sum_of({one, other, two}, HarshPart::kJudged);
  EXPECT_EQ(sum.pairs, 7);
  EXPECT_EQ(sum.errors_mm, (std::vector<double>{1, 2, 3}));
}

TEST(HarshSuite, an_unknown_kind_is_refused) {
  HarshSuiteOptions options;
  options.kinds = {"attic"};
  EXPECT_EQ(run_harsh_suite(options, {}).error().code, ErrorCode::kInvalidArgument);
}

/// A short run: one small rig of simulated harsh sensors, and both reports.
TEST(HarshSuite, draws_judges_and_reports_a_rig) {
  HarshSuiteOptions options;
  options.kinds = {"bare/structured"};
  options.sensors = 2;
  const auto rows = run_harsh_suite(options, {});
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 1u);
  EXPECT_EQ(rows->front().rigs, 1);
  EXPECT_EQ(rows->front().part, "judged");
  EXPECT_EQ(rows->front().pairs + rows->front().strangers + rows->front().refused_views > 0, true);
  std::ostringstream json, table;
  print_json(*rows, json);
  print_table(*rows, table);
  const auto parsed = nlohmann::json::parse(json.str());
  ASSERT_EQ(parsed["kinds"].size(), 2u) << "the kind and the sum of its part";
  EXPECT_EQ(parsed["kinds"][0]["kind"], "bare/structured");
  EXPECT_EQ(parsed["kinds"][1]["kind"], "all");
  EXPECT_THAT(table.str(), testing::HasSubstr("bare/structured"));
}

TEST(HarshViews, have_the_truth_of_their_sensors) {
  const auto views = harsh_views({"bare", simulator::Harshness::kTimeOfFlight, 11, 2});
  ASSERT_TRUE(views);
  ASSERT_EQ(views->size(), 2u);
  for (const HarshView& seen : *views) {
    ASSERT_TRUE(seen.view);
    EXPECT_NE(seen.depth_scale, 1);
    ASSERT_TRUE(seen.surface);
    const int x = seen.surface->z_m.width() / 2, y = seen.surface->z_m.height() / 2;
    const double truth_m = seen.surface->z_m.at(x, y), read_m = seen.view->surface.z_m.at(x, y);
    if (truth_m > 0 && read_m > 0) {
      EXPECT_NEAR(truth_m / read_m, seen.depth_scale, 0.02);
    }
  }
}

}  // namespace
}  // namespace roomcast::bench
