// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/placed_rig.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"
#include "roomcast/alignment/feature/walk_views_fixture.h"
#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/rig/rig_check.h"

namespace roomcast::alignment {
namespace {

/// One of two sensors that look past a pillar from either side. They share no surface that faces
/// sideways, so only matches constrain them sideways; but both see the end of the pillar.
ViewFixture beside_pillar(const char* name, double x) {
  RoomFixture room;
  room.coarser = 5;
  room.boxes = {{Eigen::Vector3d(-0.25, 0, -2), Eigen::Vector3d(0.25, 1, -1)}};
  return view_fixture(room, name, world_from_optical_looking_at({x, 1.3, -0.1}, {0, 0.9, -1}));
}

Eigen::Vector2f pixel_of(const SensorView& view, const Eigen::Vector3f& point_m) {
  return view.picture.pixel_of(view.picture.in_color_frame(point_m));
}

/// Matches over all of `a`'s surface that agree with a pose `aside_m` away from `b`'s true pose.
struct Group {
  std::size_t every;  // one match per so many surface points
  double aside_m;
  float weight;
};

std::vector<PointMatch> matches_in_group(const ViewFixture& a, const ViewFixture& b,
                                         const Group& group) {
  const RigidTransform b_from_a = true_pose(a, b).inverse();
  const Eigen::Vector3d aside_m =
      group.aside_m * a.world_from_depth.rotation.transpose() * Eigen::Vector3d::UnitX();
  const auto& samples = a.view->surface.samples;
  std::vector<PointMatch> matches;
  for (std::size_t i = 0; i < samples.size(); i += group.every) {
    const Eigen::Vector3f in_a = samples[i].point_m;
    const Eigen::Vector3f in_b = (b_from_a * (in_a.cast<double>() - aside_m)).cast<float>();
    if (in_b.z() < kNearestSurface_m) continue;
    matches.push_back({in_a, in_b, pixel_of(*a.view, in_a), pixel_of(*b.view, in_b), group.weight});
  }
  return matches;
}

TEST(PlacedRig, is_refined_once_more_before_it_is_said_to_contradict_itself) {
  const ViewFixture a = beside_pillar("a", -0.45), b = beside_pillar("b", 0.45);
  // The heaviest matches are furthest off. The right ones are so far from them that the steps reach
  // them only when restarted from the pose found with the others.
  std::vector<PointMatch> matches;
  for (const Group& group : {Group{43, 0.112, 1}, Group{20, 0.076, 0.01F}, Group{1, 0, 0.001F}}) {
    const auto of_group = matches_in_group(a, b, group);
    matches.insert(matches.end(), of_group.begin(), of_group.end());
  }
  const PairCandidates candidates(*a.view, *b.view, std::move(matches));
  ASSERT_FALSE(candidates.ranked().empty());
  ASSERT_TRUE(is_strong(candidates.ranked()[0]));
  const std::array<RigPair, 1> pairs = {{{0, 1, &candidates}}};

  RigAnswer once{select_poses(2, pairs), {true, true}, {}};
  once.refined = refine_rig(once.selection.best.group_from_sensor, once.selection.origin, pairs);
  ASSERT_TRUE(RigCheck().contradicted_sensor(pairs, once).has_value());

  const std::array<const SensorView*, 2> views = {a.view.get(), b.view.get()};
  const AlignmentReport report = place_rig(views, pairs);
  ASSERT_TRUE(report.sensors[0].placed && report.sensors[1].placed) << report.pairs[0].reason;
  EXPECT_LT(difference(report.pairs[0].b_from_a->inverse(), true_pose(a, b)).distance_m, 0.01);
}

TEST(PlacedRig, leaves_out_a_sensor_whose_refined_pose_no_pair_holds) {
  const ViewFixture a = beside_pillar("a", -0.45), b = beside_pillar("b", 0.45);
  const PairCandidates candidates(*a.view, *b.view, matches_in_group(a, b, {20, 0, 1}));
  const std::array<RigPair, 1> pairs = {{{0, 1, &candidates}}};
  const std::array<const SensorView*, 2> views = {a.view.get(), b.view.get()};
  ASSERT_TRUE(place_rig(views, pairs).sensors[1].placed);

  RigOptions strict;  // pooled evidence selects the pose, but nothing holds it
  strict.pair.evidence.strong_support = strict.pair.evidence.faint_score = 1e6;
  strict.placing.holding_support = strict.placing.holding_score = 1e6;
  const AlignmentReport report = place_rig(views, pairs, strict);
  for (const SensorReport& sensor : report.sensors) {
    EXPECT_FALSE(sensor.placed);
    EXPECT_NE(sensor.reason.find("surfaces do not meet"), std::string::npos) << sensor.reason;
  }
}

TEST(PlacedRig, what_moves_holds_a_pair_whose_features_no_longer_agree) {
  RoomFixture room;
  room.coarser = 3;
  const RigidTransform pose_a = world_from_optical_looking_at({-1.5, 1.8, -1.8}, {0.3, 0.8, 0.9}),
                       pose_b = world_from_optical_looking_at({1.5, 1.8, -1.8}, {-0.3, 0.8, 0.9});
  const auto a = walk_view(room, "a", pose_a), b = walk_view(room, "b", pose_b);
  const ViewFixture in_a{pose_a, a}, in_b{pose_b, b};
  const PairCandidates candidates(*a, *b, matches_in_group(in_a, in_b, {20, 0, 1}));
  ASSERT_FALSE(candidates.ranked().empty());
  const std::array<RigPair, 1> pairs = {{{0, 1, &candidates}}};
  const std::array<const SensorView*, 2> views = {a.get(), b.get()};
  RigOptions strict;  // pooled evidence selects the pose, and neither features nor colours hold it
  strict.pair.evidence.strong_support = strict.pair.evidence.faint_score = 1e6;
  strict.placing.holding_support = strict.placing.holding_score = 1e6;
  EXPECT_TRUE(place_rig(views, pairs, strict).sensors[1].placed);
  strict.contradiction.vouching_solid = 1e6;
  EXPECT_FALSE(place_rig(views, pairs, strict).sensors[1].placed);
}

}  // namespace
}  // namespace roomcast::alignment
