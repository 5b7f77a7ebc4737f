// SPDX-License-Identifier: Apache-2.0
// A running room through which a box walks, seen by sensors that report instants.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/walk_views_fixture.h"
#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/service/known_room_fixture.h"
#include "roomcast/alignment/service/placement_solver.h"
#include "roomcast/core/depth_factor.h"

namespace roomcast::alignment {
namespace {

constexpr int kWalkSteps = 24;  // there and back
constexpr double kTrueScale = 1.04;
const RigidTransform kExactStand = corner_pose(2, 1.5), kScaledStand = corner_pose(2, -1.5);

/// A sensor of the room; true depth = `scale` * reading.
struct WalkSensor {
  std::string name;
  RigidTransform world_from_depth;
  double scale = 1;
  RoomFixture room = {};

  /// With readings that it has multiplied by `applied`.
  [[nodiscard]] CalibrationBundle bundle(double applied) const {
    CalibrationBundle bundle = bundle_fixture(room, name, world_from_depth);
    multiply_depth(bundle.depth_mm.view(), applied / scale);
    bundle.depth_scale = applied;
    return bundle;
  }
  [[nodiscard]] DepthInstant instant(int nth) const {
    const int step = std::min(nth, kWalkSteps - 1 - nth);
    DepthImage picture =
        depth_fixture(room_with_walker(room, step), calibration_fixture().depth, world_from_depth);
    multiply_depth(picture.view(), 1 / scale);
    return {1000 + 0.4 * nth, depth_in_blocks(picture), {}};
  }
};

const WalkSensor kExactSensor{"left", kExactStand}, kNearSensor{"right", kScaledStand, kTrueScale};

void walk_through(PlacementSolver& placing, const WalkSensor& sensor, int instants = kWalkSteps) {
  for (int i = 0; i < instants; ++i) placing.see(sensor.name, sensor.instant(i), 1);
}

Placement entry_of(const std::string& sensor, const std::vector<Placement>& placements) {
  const auto entry = std::ranges::find(placements, sensor, &Placement::sensor);
  return entry == placements.end() ? Placement{} : *entry;
}

KnownRoom room_as_placed(const std::vector<Placement>& placements) {
  KnownRoom room;
  for (const Placement& placement : placements) room[placement.sensor].pose = placement.pose;
  return room;
}

/// A long grey corridor, along which nothing that stands still tells where a sensor is.
WalkSensor sensor_in_corridor(const std::string& name, const RigidTransform& world_from_depth) {
  RoomFixture corridor;
  corridor.walls = {Eigen::Vector3d(-30, 0, -2), Eigen::Vector3d(30, 2.6, 1.8)};
  corridor.boxes.clear();
  return {name, world_from_depth, 1, corridor};
}

TEST(PlacementByMotion, a_walk_reveals_a_sensor_that_reads_too_near) {
  PlacementSolver placing;
  placing.add(kExactSensor.bundle(1));
  placing.add(kNearSensor.bundle(1));
  placing.add(without_pattern(sensor_in_corridor("lost", kExactStand).bundle(1)));
  auto placements = placing.solve({});
  ASSERT_TRUE(entry_of("right", placements).pose.is_placed())
      << entry_of("right", placements).pose.note;
  EXPECT_EQ(entry_of("right", placements).pose.depth_scale, 1);
  ASSERT_TRUE(placing.wants_instants()) << "one sensor is not placed";
  EXPECT_FALSE(placing.has_new_instants());

  walk_through(placing, kExactSensor);
  walk_through(placing, kNearSensor);
  ASSERT_TRUE(placing.has_new_instants());
  placements = placing.solve(room_as_placed(placements));
  const Placement left = entry_of("left", placements), right = entry_of("right", placements);
  ASSERT_TRUE(left.pose.is_placed()) << left.pose.note;
  ASSERT_TRUE(right.pose.is_placed()) << right.pose.note;
  EXPECT_NEAR(right.pose.depth_scale / left.pose.depth_scale, kTrueScale, 0.02);
  const RigidTransform left_from_right =
      left.pose.world_from_depth.inverse() * right.pose.world_from_depth;
  EXPECT_LT(difference(left_from_right, kExactStand.inverse() * kScaledStand).distance_m, 0.06);

  // The sensors apply their factors, and nothing changes any more.
  placing.add(kExactSensor.bundle(left.pose.depth_scale));
  placing.add(kNearSensor.bundle(right.pose.depth_scale));
  const auto again = placing.solve(room_as_placed(placements));
  for (const Placement& before : {left, right}) {
    const Placement now = entry_of(before.sensor, again);
    EXPECT_NEAR(now.pose.depth_scale, before.pose.depth_scale, 0.01) << before.sensor;
    EXPECT_LT(difference(now.pose.world_from_depth, before.pose.world_from_depth).distance_m, 0.05)
        << before.sensor;
  }
}

TEST(PlacementByMotion, calibrated_sensors_are_asked_for_no_instants) {
  PlacementSolver placing;
  placing.add(WalkSensor{"left", kExactStand}.bundle(1));
  placing.add(WalkSensor{"right", kScaledStand}.bundle(1));
  const auto placements = placing.solve({});
  ASSERT_TRUE(entry_of("right", placements).pose.is_placed());
  EXPECT_FALSE(placing.wants_instants());
}

TEST(PlacementByMotion, sensors_that_take_no_factor_are_asked_for_no_instants) {
  PlacementSolver placing;
  for (const WalkSensor& sensor : {kExactSensor, kNearSensor}) {
    CalibrationBundle bundle = sensor.bundle(1);
    bundle.depth_scale.reset();
    placing.add(bundle);
  }
  (void)placing.solve({});
  EXPECT_FALSE(placing.wants_instants());
}

TEST(PlacementByMotion, an_estimate_that_motion_contradicts_does_not_stay) {
  const RigidTransform first = world_from_optical_looking_at({-1, 1.7, -1.6}, {-0.3, 0.6, 1});
  const RigidTransform second = world_from_optical_looking_at({1, 1.7, -1.6}, {0.3, 0.6, 1});
  RigidTransform wrong = second;
  wrong.translation_m.x() += 0.8;
  PlacementSolver placing;
  const WalkSensor one = sensor_in_corridor("first", first),
                   other = sensor_in_corridor("second", second);
  for (const WalkSensor& sensor : {one, other}) placing.add(without_pattern(sensor.bundle(1)));
  KnownRoom room = given_room({{"first", first}});
  add_poses(room, PoseSource::kEstimated, {{"second", wrong}});
  auto placements = placing.solve(room);
  ASSERT_FALSE(entry_of("second", placements).withdrawn) << "nothing contradicts it yet";

  walk_through(placing, one);
  walk_through(placing, other);
  placements = placing.solve(room);
  const Placement now = entry_of("second", placements);
  if (now.pose.is_placed()) {
    EXPECT_LT(difference(now.pose.world_from_depth, second).distance_m, 0.1);
  } else {
    EXPECT_TRUE(now.withdrawn);
    EXPECT_NE(now.pose.note.find("what moves"), std::string::npos) << now.pose.note;
  }
}

TEST(PlacementByMotion, instants_of_another_camera_are_left_out) {
  PlacementSolver placing;
  placing.add(kExactSensor.bundle(1));
  placing.add(kNearSensor.bundle(1));
  placing.add(without_pattern(sensor_in_corridor("lost", kExactStand).bundle(1)));
  const auto placements = placing.solve({});
  ASSERT_TRUE(placing.wants_instants());
  walk_through(placing, kExactSensor);
  // Its sensor came back with a smaller camera, whose bundle is still to come.
  for (int i = 0; i < kWalkSteps; ++i) {
    DepthInstant smaller = kNearSensor.instant(i);
    smaller.depth_mm = DepthImage(smaller.depth_mm.width() / 2, smaller.depth_mm.height() / 2, 900);
    placing.see(kNearSensor.name, std::move(smaller), 1);
  }
  EXPECT_FALSE(placing.has_new_instants());

  // The bundle comes, with another factor besides.
  CalibrationBundle bundle = kNearSensor.bundle(1.02);
  bundle.calibration.depth.width /= 2;
  bundle.calibration.depth.height /= 2;
  bundle.calibration.depth.cx /= 2;
  bundle.calibration.depth.cy /= 2;
  bundle.calibration.depth.fx /= 2;
  bundle.calibration.depth.fy /= 2;
  bundle.depth_mm = depth_fixture(kNearSensor.room, bundle.calibration.depth, kScaledStand);
  walk_through(placing, kNearSensor);
  placing.add(bundle);
  EXPECT_FALSE(placing.has_new_instants()) << "what it saw before was with another camera";
  (void)placing.solve(room_as_placed(placements));
}

}  // namespace
}  // namespace roomcast::alignment
