// SPDX-License-Identifier: Apache-2.0
// Alignment of recordings with known poses, where they are available (ROOMCAST_DATA).
#include "roomcast/recording/align/recorded_views.h"

#include <array>
#include <numbers>

#include <gtest/gtest.h>

#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/rig/rig_aligner.h"
#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/recording/dataset/rig_json.h"

namespace roomcast::recording {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
const ReadProgress kQuiet = [](const std::string&) {};

bool is_at_hand(const char* folder) {
  return std::filesystem::exists(shared_data() / folder);
}

TEST(RecordedAlignment, places_three_sensors_on_a_floor_that_repeats) {
  if (!is_at_hand("house3"))
    GTEST_SKIP() << "no recordings at " << shared_data() << "; set ROOMCAST_DATA to test with them";
  const auto bundles = read_rig_bundles(shared_data() / "house3", kQuiet);
  const auto rig = read_rig_json(shared_data() / "house3" / "rig.json");
  ASSERT_TRUE(bundles.ok() && rig.ok());
  alignment::RigAligner aligner;
  for (const RecordedBundle& recorded : *bundles) aligner.add(*view_of(recorded));
  const alignment::AlignmentReport report = aligner.solve();
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(report.sensors[i].placed) << report.sensors[i].reason;
    const RigidTransform found =
        report.sensors[0].world_from_depth->inverse() * *report.sensors[i].world_from_depth;
    const RigidTransform truth =
        rig->sensors[0].world_from_depth->inverse() * *rig->sensors[i].world_from_depth;
    const auto error = alignment::difference(found, truth);
    EXPECT_LT(error.angle_rad, 0.2 * kDegree) << report.sensors[i].id;
    EXPECT_LT(error.distance_m, 0.010) << report.sensors[i].id;
  }
}

/// Easier and harder pairs from a hand-held Kinect. The reference poses themselves are accurate to
/// a few centimetres.
TEST(RecordedAlignment, finds_the_relative_poses_of_a_real_kinects_frames) {
  if (!is_at_hand("redkitchen_moving"))
    GTEST_SKIP() << "no recordings at " << shared_data() << "; set ROOMCAST_DATA to test with them";
  const auto folder = shared_data() / "redkitchen_moving";
  const auto listed = read_pair_list(folder / "alignment_pairs.json");
  ASSERT_TRUE(listed.ok());
  std::vector<ListedPair> pairs;
  for (const std::size_t i : {0, 30, 66}) pairs.push_back(listed->at(i));
  auto frames = FrameViews::read(folder, pairs, kQuiet);
  ASSERT_TRUE(frames.ok());
  for (const ListedPair& pair : pairs) {
    alignment::RigAligner aligner;
    aligner.add(*frames->at(pair.a));
    aligner.add(*frames->at(pair.b));
    const auto found = aligner.solve().pairs.at(0);
    ASSERT_TRUE(found.b_from_a.has_value()) << pair.a << " " << pair.b << ": " << found.reason;
    const auto error = alignment::difference(*found.b_from_a, *pair.b_from_a, {0, 0, 0});
    EXPECT_LT(error.angle_rad, 5 * kDegree) << pair.a << " " << pair.b;
    EXPECT_LT(error.distance_m, 0.1) << pair.a << " " << pair.b;
  }
}

}  // namespace
}  // namespace roomcast::recording
