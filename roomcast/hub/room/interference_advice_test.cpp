// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/interference_advice.h"

#include <numbers>

#include "roomcast/geometry/rotations.h"
#include "roomcast/hub/room/room_test_fixture.h"

namespace roomcast::hub {
namespace {

using testing::HasSubstr;

pb::Join seeing_join(const std::string& name, const RigidTransform& world_from_depth) {
  pb::Join join = sensor_join(name, world_from_depth);
  auto& lens = *join.mutable_sensor()->mutable_calibration()->mutable_depth();
  lens.set_width(640);
  lens.set_height(480);
  lens.set_fx(580);
  lens.set_fy(580);
  lens.set_cx(319.5);
  lens.set_cy(239.5);
  return join;
}

/// At (x, 0, 0), turned about the vertical axis.
RigidTransform looking(double x, double turn_deg) {
  const double angle = turn_deg * std::numbers::pi / 180;
  return {rotation_about(Eigen::Vector3d::UnitY(), angle), {x, 0, 0}};
}

class InterferenceAdviceTest : public RoomTest {
 protected:
  /// Sensor 0 beside sensor 1, and sensor 2 with its back to both.
  void SetUp() override {
    enter(seeing_join("left", looking(0, 0)));
    enter(seeing_join("right", looking(1, 0)));
    enter(seeing_join("back", looking(0.5, 180)));
  }
  void report(std::uint64_t connection, float flickering, float noise_ratio) {
    pb::Control message;
    message.mutable_sensor_health()->set_flickering(flickering);
    message.mutable_sensor_health()->set_noise_ratio(noise_ratio);
    EXPECT_TRUE(room.control(ConnectionId{connection}, message, at(1s)).empty());
  }
  std::optional<SensorInterference> of(std::size_t sensor) const {
    return room.stats().sensors.at(sensor).interference;
  }
};

TEST_F(InterferenceAdviceTest, nothing_is_known_before_a_report) {
  EXPECT_FALSE(of(0));
}

TEST_F(InterferenceAdviceTest, the_neighbour_that_lights_most_of_the_view_is_named) {
  report(1, 0.04F, 1);
  const auto left = of(0);
  ASSERT_TRUE(left);
  EXPECT_EQ(left->neighbour, "right");
  EXPECT_GT(left->shared, 0.3);
  EXPECT_LT(left->shared, 0.9);
  EXPECT_THAT(left->advice, HasSubstr("\"right\" lights"));
}

TEST_F(InterferenceAdviceTest, an_undisturbed_sensor_gets_no_advice) {
  report(1, 0.002F, 1.2F);
  EXPECT_EQ(of(0)->advice, "");
  report(1, 0.002F, 2.5F);
  EXPECT_NE(of(0)->advice, "");
}

TEST_F(InterferenceAdviceTest, without_a_neighbour_nobody_is_blamed) {
  report(3, 0.04F, 1);
  EXPECT_EQ(of(2)->neighbour, "");
  EXPECT_THAT(of(2)->advice, HasSubstr("Another infrared camera"));
}

TEST_F(InterferenceAdviceTest, a_sensor_that_left_is_not_blamed_and_reports_nothing) {
  report(1, 0.04F, 1);
  (void)room.leave(ConnectionId{2}, at(2s));
  EXPECT_EQ(of(0)->neighbour, "");
  (void)room.leave(ConnectionId{1}, at(2s));
  EXPECT_FALSE(of(0));
}

TEST_F(InterferenceAdviceTest, only_sensors_report_their_health) {
  const ConnectionId viewer = enter(viewer_join());
  pb::Control message;
  message.mutable_sensor_health();
  EXPECT_EQ(all<Disconnect>(room.control(viewer, message, at(1s))).size(), 1U);
}

}  // namespace
}  // namespace roomcast::hub
