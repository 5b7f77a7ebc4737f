// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/visibility/view_culling.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;

constexpr ConnectionId kAda{7}, kBob{8};
constexpr SensorId kFront{0}, kBack{2};
constexpr float kBehind = std::numbers::pi_v<float>;

RoomTime cull_time(nanoseconds time) {
  return RoomTime(1h + time);
}

/// A point 2 m ahead of somebody at the origin who looks towards -z, or behind, seen from there.
SeenSurface surface(float z) {
  return {{{{0, 1.6F, z}, {0, 0, z < 0 ? 1.0F : -1.0F}}}};
}

wire::pb::ViewerPose looking(float left_rad, float half_angle = 0.7F) {
  wire::pb::ViewerPose pose;
  pose.mutable_head()->set_y(1.6F);
  pose.mutable_head()->set_qy(std::sin(left_rad / 2));
  pose.mutable_head()->set_qw(std::cos(left_rad / 2));
  pose.set_view_half_angle(half_angle);
  return pose;
}

class ViewCullingTest : public testing::Test {
 protected:
  void SetUp() override {
    culling.set_surface(kFront, surface(-2));
    culling.set_surface(kBack, surface(2));
  }
  /// Runs to this time; the details that Ada has then.
  SensorDetails run_to(nanoseconds time) {
    while (culling.next() && *culling.next() <= cull_time(time)) {
      for (auto& change : culling.update(*culling.next())) {
        ++changes;
        if (change.viewer == kAda) details = change.details;
        resumed.insert(resumed.end(), change.resumed.begin(), change.resumed.end());
      }
    }
    return details;
  }
  Detail front() const { return detail_of(details, kFront); }
  Detail back() const { return detail_of(details, kBack); }

  ViewCulling culling;
  SensorDetails details;
  std::vector<SensorId> resumed;
  int changes = 0;
};

TEST_F(ViewCullingTest, what_is_not_seen_goes_to_its_base_and_then_pauses) {
  culling.viewer_moved(kAda, looking(0), cull_time(0s));
  run_to(400ms);
  EXPECT_EQ(back(), Detail::kAll) << "at first everything comes";
  run_to(600ms);
  EXPECT_EQ(back(), Detail::kBaseOnly);
  run_to(2900ms);
  EXPECT_EQ(back(), Detail::kBaseOnly);
  run_to(3100ms);
  EXPECT_EQ(back(), Detail::kPaused);
  EXPECT_EQ(front(), Detail::kAll);
  EXPECT_FALSE(culling.next()) << "nothing more can happen";
}

TEST_F(ViewCullingTest, a_sensor_comes_back_at_once) {
  culling.viewer_moved(kAda, looking(0), cull_time(0s));
  run_to(10s);
  ASSERT_EQ(back(), Detail::kPaused);
  culling.viewer_moved(kAda, looking(kBehind), cull_time(10s));
  run_to(10s);
  EXPECT_EQ(back(), Detail::kAll);
  EXPECT_EQ(resumed, std::vector{kBack});
}

TEST_F(ViewCullingTest, a_sensor_comes_back_before_a_turning_head_sees_it) {
  culling.viewer_moved(kAda, looking(0), cull_time(0s));
  run_to(10s);
  // 2.5 radians a second: it sees the point behind from 2.44 radians on.
  float turned = 0;
  for (nanoseconds time = 10s; back() != Detail::kAll && turned < 3; time += 50ms) {
    turned += 0.125F;
    culling.viewer_moved(kAda, looking(turned), cull_time(time));
    run_to(time);
  }
  EXPECT_LT(turned, kBehind - 0.7F - 0.5F) << "0.2 s before";
}

TEST_F(ViewCullingTest, the_base_stays_longer_the_more_viewers_a_key_frame_would_go_to) {
  culling.viewer_moved(kAda, looking(0), cull_time(0s));
  culling.viewer_moved(kBob, looking(kBehind), cull_time(0s));
  run_to(5900ms);
  EXPECT_EQ(back(), Detail::kBaseOnly);
  run_to(6100ms);
  EXPECT_EQ(back(), Detail::kPaused);
  culling.forget_viewer(kBob);
}

TEST_F(ViewCullingTest, a_viewer_without_an_angle_gets_everything) {
  culling.viewer_moved(kAda, looking(0, 0), cull_time(0s));
  run_to(10s);
  EXPECT_EQ(changes, 0);
  culling.viewer_moved(kAda, looking(0), cull_time(10s));
  run_to(20s);
  ASSERT_EQ(back(), Detail::kPaused);
  culling.viewer_moved(kAda, looking(0, 0), cull_time(20s));
  run_to(21s);
  EXPECT_EQ(back(), Detail::kAll);
}

TEST_F(ViewCullingTest, a_sensor_of_which_nothing_is_known_comes_whole) {
  culling.viewer_moved(kAda, looking(0), cull_time(0s));
  run_to(10s);
  ASSERT_EQ(back(), Detail::kPaused);
  culling.forget_sensor(kBack);
  run_to(11s);
  EXPECT_EQ(back(), Detail::kAll);
}

TEST_F(ViewCullingTest, surfaces_that_appear_in_view_bring_their_sensor_back) {
  culling.viewer_moved(kAda, looking(0), cull_time(0s));
  run_to(10s);
  SeenSurface with_a_person = surface(2);
  with_a_person.points.push_back({{0, 1.6F, -1}, {0, 0, 1}});
  culling.set_surface(kBack, with_a_person);
  run_to(11s);
  EXPECT_EQ(back(), Detail::kAll);
}

TEST_F(ViewCullingTest, a_head_that_jumps_is_looked_at_ten_times_a_second_at_most) {
  for (int i = 0; i < 1000; ++i) {
    culling.viewer_moved(kAda, looking(i % 2 == 0 ? 0 : kBehind), cull_time(i * 10ms));
    run_to(i * 10ms);
  }
  EXPECT_LE(changes, 100);
}

TEST_F(ViewCullingTest, a_head_at_rest_has_one_cone_and_a_turning_one_has_more_ahead) {
  EXPECT_TRUE(culling.cones(cull_time(0s)).empty()) << "nobody has told where he looks";
  culling.viewer_moved(kAda, looking(0), cull_time(0s));
  ASSERT_EQ(culling.cones(cull_time(1s)).size(), 1U);
  EXPECT_GT(culling.cones(cull_time(1s))[0].angles.half_angle_rad, 0.7F);
  culling.viewer_moved(kAda, looking(0), cull_time(2s));
  culling.viewer_moved(kAda, looking(0.1F), cull_time(2050ms));
  const auto turning = culling.cones(cull_time(2050ms));
  ASSERT_EQ(turning.size(), 3U);
  EXPECT_LT(turning[1].forward.x(), turning[0].forward.x());
  EXPECT_LT(turning[2].forward.x(), turning[1].forward.x());
}

TEST_F(ViewCullingTest, cones_have_the_sides_of_a_picture_and_a_margin) {
  wire::pb::ViewerPose pose = looking(0, 0.9F);
  pose.set_view_half_width(0.8F);
  culling.viewer_moved(kAda, pose, cull_time(0s));
  const auto cones = culling.cones(cull_time(1s));
  ASSERT_EQ(cones.size(), 1U);
  EXPECT_GT(cones[0].angles.half_width_rad, 0.8);
  EXPECT_LT(cones[0].angles.half_width_rad, 0.9);
  EXPECT_EQ(cones[0].angles.half_height_rad, 0) << "it was not told";
  EXPECT_LT((cones[0].up - Eigen::Vector3f::UnitY()).norm(), 1e-5F);
}

TEST_F(ViewCullingTest, there_are_no_cones_while_somebody_gets_everything) {
  culling.viewer_moved(kAda, looking(0), cull_time(0s));
  culling.viewer_moved(kBob, looking(kBehind), cull_time(0s));
  EXPECT_EQ(culling.cones(cull_time(1s)).size(), 2U);
  culling.viewer_moved(kBob, looking(kBehind, 0), cull_time(1s));
  EXPECT_TRUE(culling.cones(cull_time(1s)).empty());
}

}  // namespace
}  // namespace roomcast::hub
