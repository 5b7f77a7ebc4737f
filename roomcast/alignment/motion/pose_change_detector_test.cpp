// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/motion/pose_change_detector.h"

#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"

namespace roomcast::alignment {
namespace {

using namespace std::chrono_literals;

constexpr double kDegree = std::numbers::pi / 180;

RigidTransform initial_pose() {
  return corner_pose(2, 1.5);
}

DepthImage seen_from(const RigidTransform& world_from_depth, const RoomFixture& room = {}) {
  return depth_fixture(room, calibration_fixture().depth, world_from_depth);
}

RigidTransform pushed(double shift_m, double turn_rad) {
  RigidTransform push;
  push.translation_m = shift_m * Eigen::Vector3d(1, 1, 1).normalized();
  push.rotation = Eigen::AngleAxisd(turn_rad, Eigen::Vector3d(1, 1, 0).normalized()).matrix();
  return initial_pose() * push;
}

/// The time from the change of the picture to `now` until its detection; nothing if it takes more
/// than 15 s.
std::optional<nanoseconds> noticed_after(const DepthImage& now) {
  PoseChangeDetector watch(bundle_fixture({}, "s0", initial_pose()));
  const DepthImage still = seen_from(initial_pose());
  constexpr auto kFrame = 33ms;
  HostTime time(1h);
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(watch.moved(still.view(), time += kFrame));
  for (nanoseconds since{}; since < 15s; since += kFrame) {
    if (watch.moved(now.view(), time += kFrame)) return since;
  }
  return std::nullopt;
}

TEST(PoseChangeDetector, two_centimetres_are_noticed_within_two_seconds) {
  EXPECT_LT(noticed_after(seen_from(pushed(0.02, 0))).value_or(1h), 2s);
}

TEST(PoseChangeDetector, half_a_degree_is_noticed_within_two_seconds) {
  EXPECT_LT(noticed_after(seen_from(pushed(0, 0.5 * kDegree))).value_or(1h), 2s);
}

TEST(PoseChangeDetector, a_sensor_turned_away_is_noticed_within_two_seconds) {
  EXPECT_LT(noticed_after(seen_from(pushed(0, 35 * kDegree))).value_or(1h), 2s);
}

TEST(PoseChangeDetector,
     a_sensor_turned_to_a_wall_is_noticed_later_for_it_might_be_somebody_before_it) {
  const auto noticed = noticed_after(seen_from(pushed(0, -40 * kDegree))).value_or(1h);
  EXPECT_GT(noticed, 2s);
  EXPECT_LT(noticed, 12s);
}

TEST(PoseChangeDetector, a_centimetre_and_a_fifth_of_a_degree_are_borne) {
  EXPECT_FALSE(noticed_after(seen_from(pushed(0.01, 0))));
  EXPECT_FALSE(noticed_after(seen_from(pushed(0, 0.2 * kDegree))));
}

TEST(PoseChangeDetector, furniture_that_is_pushed_is_none_of_its_business) {
  RoomFixture room;
  room.boxes[0].translate(Eigen::Vector3d(0.3, 0, 0.2));
  EXPECT_FALSE(noticed_after(seen_from(initial_pose(), room)));
}

TEST(PoseChangeDetector, a_knock_that_swings_back_is_none) {
  PoseChangeDetector watch(bundle_fixture({}, "s0", initial_pose()));
  const DepthImage still = seen_from(initial_pose()), knocked = seen_from(pushed(0.05, 0.02));
  HostTime time(1h);
  for (int knock = 0; knock < 4; ++knock) {
    EXPECT_FALSE(watch.moved(knocked.view(), time += kCheckInterval));
    EXPECT_FALSE(watch.moved(knocked.view(), time += kCheckInterval));
    EXPECT_FALSE(watch.moved(still.view(), time += kCheckInterval));
  }
}

/// A person walks through the room, close to the sensor at the end.
TEST(PoseChangeDetector, a_walker_is_no_motion_of_the_sensor) {
  PoseChangeDetector watch(bundle_fixture({}, "s0", initial_pose()));
  HostTime time(1h);
  for (double z_m = 3.5; z_m > 0.4; z_m -= 0.1) {
    RoomFixture room;
    const Eigen::Vector3d at = initial_pose() * Eigen::Vector3d(0.15 * z_m, 0.1, z_m);
    room.boxes.push_back({Eigen::Vector3d(at.x() - 0.25, 0, at.z() - 0.2),
                          Eigen::Vector3d(at.x() + 0.25, 1.75, at.z() + 0.2)});
    EXPECT_FALSE(watch.moved(seen_from(initial_pose(), room).view(), time += kCheckInterval))
        << z_m;
  }
}

}  // namespace
}  // namespace roomcast::alignment
