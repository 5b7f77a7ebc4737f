// SPDX-License-Identifier: Apache-2.0
// Two sensors side by side in front of a printed wall, with whatever is missing for each refusal.
#include "roomcast/alignment/rig/refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/alignment/pair/wall_matches_fixture.h"

namespace roomcast::alignment {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::size_t kEnoughFeatures = 50;

SensorView wall_view_with_features(const std::string& name, double x_m,
                                   const PrintedWall& wall = {}) {
  SensorView view = wall_view(wall, x_m, name);
  view.picture_features.features.resize(kEnoughFeatures - 10);
  view.picture_features.descriptors.resize(kEnoughFeatures - 10);
  view.rectified_features.features.resize(10);
  view.rectified_features.descriptors.resize(10);
  return view;
}

std::string why_refused(const SensorView& a, const SensorView& b,
                        const std::vector<PointMatch>& matches) {
  return why_pair_is_refused(PairCandidates(a, b, matches));
}

TEST(Refusal, a_pair_that_determines_its_pose_is_not_refused) {
  const SensorView a = wall_view_with_features("left", 0);
  const SensorView b = wall_view_with_features("right", 0.6);
  EXPECT_THAT(why_refused(a, b, wall_matches(a, b, wall_pose(0, 0.6))), IsEmpty());
}

TEST(Refusal, names_two_sensors_that_gave_the_same_pictures) {
  const SensorView a = wall_view_with_features("left", 0);
  const SensorView b = wall_view_with_features("right", 0);
  const std::string reason = why_refused(a, b, wall_matches(a, b, {}));
  EXPECT_THAT(reason, HasSubstr("left and right gave the very same pictures"));
}

TEST(Refusal, names_the_sensor_that_sees_hardly_any_texture) {
  const SensorView a = wall_view_with_features("left", 0);
  SensorView b = wall_view_with_features("right", 0.6);
  b.picture_features.features.pop_back();
  EXPECT_THAT(why_refused(a, b, {}), HasSubstr("right sees hardly any texture"));
  EXPECT_THAT(why_refused(b, a, {}), HasSubstr("right sees hardly any texture"));
}

TEST(Refusal, says_that_nothing_common_could_be_found) {
  const SensorView a = wall_view_with_features("left", 0);
  const SensorView b = wall_view_with_features("right", 0.6);
  EXPECT_THAT(why_refused(a, b, {}), HasSubstr("no overlap of left and right was found"));
}

TEST(Refusal, says_that_several_poses_fit) {
  // A print that repeats every metre, and matches for two poses a metre apart.
  const PrintedWall repeating{.period_m = 1};
  const SensorView a = wall_view_with_features("left", 0, repeating);
  const SensorView b = wall_view_with_features("right", 0.5, repeating);
  auto matches = wall_matches(a, b, wall_pose(0, 0.5));
  const auto of_rival = wall_matches(a, b, wall_pose(0, -0.5));
  matches.insert(matches.end(), of_rival.begin(), of_rival.end());
  EXPECT_THAT(why_refused(a, b, matches), HasSubstr("several poses of left and right fit"));
}

/// Matches on the strip that both see if b is 2.5 m to the right of a. They are worth
/// little.
std::vector<PointMatch> matches_on_a_strip(const SensorView& a, const SensorView& b) {
  std::vector<PointMatch> matches;
  for (const float x : {1.2F, 1.25F, 1.3F}) {
    for (float y = -1; y < 1; y += 0.1F) {
      const Eigen::Vector3f in_a(x, y, 2), in_b(x - 2.5F, y, 2);
      matches.push_back({in_a, in_b, a.picture.pixel_of(in_a), b.picture.pixel_of(in_b), 0.06F});
    }
  }
  return matches;
}

TEST(Refusal, says_how_little_the_views_share) {
  const SensorView a = wall_view_with_features("left", 0);
  const SensorView b = wall_view_with_features("right", 2.5);
  // Of 2.7 m 0.2 are common, less than 8 %.
  EXPECT_THAT(why_refused(a, b, matches_on_a_strip(a, b)),
              HasSubstr("left and right share only about"));
}

TEST(Refusal, says_how_few_places_agree) {
  const SensorView a = wall_view_with_features("left", 0);
  const SensorView b = wall_view_with_features("right", 0.6);
  const auto matches = wall_matches(a, b, wall_pose(0, 0.6), 2, 0.01F);
  const std::string found = std::to_string(matches.size());  // 12 cm apart: each is a place
  EXPECT_THAT(why_refused(a, b, matches),
              HasSubstr("too few places agree between left and right (" + found + " found)"));
}

TEST(Refusal, of_a_pair_placed_through_others_says_what_it_lacks) {
  const SensorView a = wall_view_with_features("left", 0);
  const SensorView b = wall_view_with_features("right", 0.6);
  const PairCandidates pair(a, b, {});
  PoseEvidence evidence;
  evidence.space.consistent = 0.05;
  EXPECT_THAT(why_pair_says_little(pair, evidence),
              HasSubstr("left and right share only about 5 % of their views"));
  evidence.space.consistent = 0.3;
  EXPECT_THAT(why_pair_says_little(pair, evidence), HasSubstr("too few places in common"));
  EXPECT_THAT(why_pair_says_little(pair, evidence), HasSubstr("placed through other sensors"));
}

}  // namespace
}  // namespace roomcast::alignment
