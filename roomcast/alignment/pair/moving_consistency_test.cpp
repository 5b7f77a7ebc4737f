// SPDX-License-Identifier: Apache-2.0
// A room that looks the same after half a turn, and a walker who is on one side of it.
#include "roomcast/alignment/pair/moving_consistency.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"
#include "roomcast/alignment/feature/walk_views_fixture.h"
#include "roomcast/alignment/pair/pair_candidates.h"

namespace roomcast::alignment {
namespace {

const RigidTransform kOneCorner = corner_pose(2, 1.5), kOtherCorner = corner_pose(-2, 1.5);

struct WalkPair {
  std::shared_ptr<const SensorView> a = walk_view({}, "a", kOneCorner);
  std::shared_ptr<const SensorView> b = walk_view({}, "b", kOtherCorner);
  RigidTransform truth = kOneCorner.inverse() * kOtherCorner;

  /// The pose of b if the room were turned by half about its middle.
  [[nodiscard]] static RigidTransform half_turned() {
    RigidTransform half;
    half.rotation = Eigen::Vector3d(-1, 1, -1).asDiagonal();
    return kOneCorner.inverse() * half * kOtherCorner;
  }
};

TEST(MovingConsistency, a_walker_is_where_both_see_him_at_the_true_pose) {
  const WalkPair pair;
  const MovingConsistency check = check_moving(*pair.a, *pair.b, pair.truth);
  EXPECT_GT(check.consistent, 100);
  EXPECT_LT(check.conflict(), 0.05);
}

TEST(MovingConsistency, half_a_turn_puts_the_walker_where_nobody_is) {
  const WalkPair pair;
  const MovingConsistency check = check_moving(*pair.a, *pair.b, WalkPair::half_turned());
  EXPECT_GT(check.violating, 50);
  EXPECT_GT(check.conflict(), 0.8);
}

TEST(MovingConsistency, other_times_say_nothing) {
  const WalkPair pair;
  SensorView late = *pair.b;
  for (DepthInstant& instant : late.instants) instant.time_s += 60;
  EXPECT_EQ(check_moving(*pair.a, late, pair.truth).judged(), 0);
  EXPECT_EQ(check_moving(*pair.a, late, WalkPair::half_turned()).judged(), 0);
}

TEST(MovingConsistency, refutes_a_pose_in_the_evidence) {
  const WalkPair pair;
  const PairCandidates candidates(*pair.a, *pair.b, {});
  EXPECT_LT(candidates.examine(WalkPair::half_turned()).score, 0);
  EXPECT_GT(candidates.examine(pair.truth).score, 0);
}

TEST(InstantAt, is_the_nearest_within_reach) {
  const std::vector<DepthInstant> instants = {{1.0, {}, {}}, {2.0, {}, {}}};
  EXPECT_EQ(instant_at(instants, 1.9, 0.2), &instants[1]);
  EXPECT_EQ(instant_at(instants, 1.5, 0.2), nullptr);
  EXPECT_EQ(instant_at({}, 1.5, 0.2), nullptr);
}

}  // namespace
}  // namespace roomcast::alignment
