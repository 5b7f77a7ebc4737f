// SPDX-License-Identifier: Apache-2.0
#include "bench/align/align_bench.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "bench/align/fpfh_ransac.h"
#include "bench/align/sift_pnp.h"
#include "roomcast/alignment/feature/views_fixture.h"
#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::bench {
namespace {

using alignment::first_corner;
using alignment::second_corner;

AlignInput corner_room_input() {
  AlignInput input;
  input.name = "corner_room_input";
  input.views = {first_corner().view, second_corner().view};
  input.cases = {{0, 1, alignment::true_pose(first_corner(), second_corner()), 0.2}};
  input.whole_rig = true;
  return input;
}

TEST(AlignBench, puts_all_methods_side_by_side) {
  const auto rows = run_align_bench({corner_room_input()}, {});
  ASSERT_EQ(rows.size(), 5u);
  for (const AlignRow& row : rows) {
    EXPECT_EQ(row.pairs, 1);
    EXPECT_EQ(row.overlap, "10-30 %");
    EXPECT_EQ(row.right + row.accepted_wrong, row.accepted);
  }
  EXPECT_EQ(rows[3].method, "roomcast, pair alone");
  EXPECT_EQ(rows[3].right, 1);
  EXPECT_EQ(rows[4].right, 1);
}

TEST(AlignBench, judges_by_the_truth_it_is_given) {
  AlignInput input = corner_room_input();
  input.cases[0].a_from_b.translation_m.x() += 0.2;
  const auto rows = run_align_bench({input}, {});
  EXPECT_EQ(rows[4].right, 0);
  EXPECT_EQ(rows[4].accepted_wrong, 1);
}

TEST(AlignBench, reports_as_json_and_as_a_table) {
  const std::vector<AlignRow> rows = {
      {"kitchen", "SIFT + PnP", ">60 %", 24, 22, 23, 1, 0.5, 25, 0.2}};
  std::ostringstream json, table;
  print_json(rows, json);
  print_table(rows, table);
  EXPECT_EQ(nlohmann::json::parse(json.str())["rows"][0]["right"], 22);
  EXPECT_THAT(table.str(), testing::HasSubstr("22 of 24"));
}

const alignment::ViewFixture& beside() {
  static const alignment::ViewFixture view = alignment::view_fixture(
      {}, "beside", world_from_optical_looking_at({1.9, 1.9, 1.4}, {0.3, 0.4, -0.3}));
  return view;
}

TEST(SiftPnp, finds_a_neighbouring_view) {
  const auto pose = sift_pnp_pose(*first_corner().view, *beside().view);
  ASSERT_TRUE(pose.has_value());
  EXPECT_LT(alignment::difference(*pose, alignment::true_pose(first_corner(), beside())).distance_m,
            0.1);
}

TEST(FpfhRansac, finds_a_view_in_itself) {
  const auto pose = fpfh_ransac_pose(*first_corner().view, *first_corner().view);
  ASSERT_TRUE(pose.has_value());
  EXPECT_LT(alignment::difference(*pose, RigidTransform{}).distance_m, 0.1);
}

}  // namespace
}  // namespace roomcast::bench
