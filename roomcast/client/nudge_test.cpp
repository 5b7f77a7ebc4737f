// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/nudge.h"

#include <cmath>
#include <future>
#include <numbers>
#include <optional>
#include <thread>

#include <gtest/gtest.h>

#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/client/room/calibration_message.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

wire::pb::Control roster(const RigidTransform& pose, const std::string& note = "") {
  wire::pb::Control control;
  SensorCalibration calibration;
  calibration.depth = {.width = 64, .height = 48, .fx = 60, .fy = 60, .cx = 32, .cy = 24};
  calibration.color = calibration.depth;
  auto& entry = *control.mutable_roster()->add_sensors();
  entry.set_id(3);
  entry.set_name("left");
  entry.set_fps(30);
  *entry.mutable_calibration() = message_from_calibration(calibration);
  wire::write_transform(pose, *entry.mutable_world_from_depth());
  entry.set_placement(wire::pb::PLACEMENT_ALIGNED);
  entry.set_expected_error_mm(4);
  entry.set_placement_note(note);
  return control;
}

RigidTransform at(double x) {
  RigidTransform pose;
  pose.translation_m = {x, 1, 0};
  return pose;
}

/// A hub with a sensor at x = 1 that answers a nudge with this message.
class NudgeTest : public testing::Test {
 protected:
  NudgeTest() {
    network.start();
    options.hub_url = hub->url();
    options.sensor = "left";
    options.credential.token = "sesame";
    options.shift_m = {0.5, 0, 0};
  }
  ~NudgeTest() override {
    network.finish([this] { hub.reset(); });
  }
  void show_roster() {
    run([](FakeHub& own) { own.on_join = [&own] { own.say(roster(at(1))); }; });
  }
  /// Sends the answer after the hub has received a nudge.
  std::jthread answering(wire::pb::Control answer) {
    return std::jthread([this, answer](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        bool heard = false;
        run([&](FakeHub& own) {
          for (const auto& message : own.heard) heard |= message.has_nudge();
          if (heard) own.say(answer);
        });
        if (heard) return;
        std::this_thread::yield();
      }
    });
  }
  template <class Action>
  void run(Action action) {
    std::promise<void> done;
    boost::asio::post(network.io(), [&] {
      action(*hub);
      done.set_value();
    });
    done.get_future().get();
  }

  NetworkThread network;
  std::optional<FakeHub> hub{std::in_place, network.io()};
  NudgeOptions options;
};

TEST_F(NudgeTest, a_guess_that_is_taken_gives_the_refined_pose) {
  show_roster();
  const auto aligner = answering(roster(at(1.47)));
  const auto answer = nudge_sensor(options);
  ASSERT_TRUE(answer.ok()) << answer.error().message;
  EXPECT_DOUBLE_EQ(answer->world_from_depth.translation_m.x(), 1.47);
  EXPECT_EQ(answer->expected_error_mm, 4);
  run([](FakeHub& own) {
    for (const auto& message : own.heard) {
      if (message.has_nudge()) {
        EXPECT_DOUBLE_EQ(message.nudge().world_from_depth(3), 1.5);
      }
    }
  });
}

TEST_F(NudgeTest, a_guess_that_is_refused_gives_the_reason) {
  show_roster();
  const auto aligner = answering(roster(at(1), "The proposed pose was refused: nothing fits"));
  const auto answer = nudge_sensor(options);
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.error().message, "The proposed pose was refused: nothing fits");
}

TEST_F(NudgeTest, a_sensor_that_has_supplied_its_pose_is_not_moved_and_that_is_said_at_once) {
  wire::pb::Control given = roster(at(1));
  given.mutable_roster()->mutable_sensors(0)->set_placement(wire::pb::PLACEMENT_GIVEN);
  run([&](FakeHub& own) { own.on_join = [&own, given] { own.say(given); }; });
  const auto answer = nudge_sensor(options);
  ASSERT_FALSE(answer.ok());
  EXPECT_NE(answer.error().message.find("\"left\" has supplied its pose"), std::string::npos)
      << answer.error().message;
  run([](FakeHub& own) {
    for (const auto& message : own.heard) EXPECT_FALSE(message.has_nudge());
  });
}

TEST_F(NudgeTest, an_unknown_sensor_is_named) {
  show_roster();
  options.sensor = "right";
  EXPECT_EQ(nudge_sensor(options).error().code, ErrorCode::kNotFound);
}

TEST_F(NudgeTest, a_room_that_no_hub_can_read_is_refused_at_once) {
  options.room = "\xff";
  EXPECT_EQ(nudge_sensor(options).error().message, "the room's name is not valid UTF-8");
}

TEST_F(NudgeTest, without_an_aligner_the_wait_ends) {
  show_roster();
  options.patience = 100ms;
  EXPECT_EQ(nudge_sensor(options).error().code, ErrorCode::kUnavailable);
}

TEST(Nudged, a_sensor_is_turned_in_place_and_then_shifted) {
  NudgeOptions by;
  by.shift_m = {0, 0, 2};
  by.turn_rad = std::numbers::pi / 2;
  const auto pose = nudged(at(1), by);
  EXPECT_TRUE(pose.translation_m.isApprox(Eigen::Vector3d(1, 1, 2)));
  EXPECT_TRUE((pose.rotation * Eigen::Vector3d(0, 0, -1)).isApprox(Eigen::Vector3d(-1, 0, 0)));
}

TEST(Nudged, a_sensor_is_tilted_upwards_about_its_own_horizontal_axis) {
  RigidTransform level;  // optical frame: y is down, z ahead
  level.rotation = Eigen::Vector3d(1, -1, -1).asDiagonal();
  NudgeOptions by;
  by.tilt_rad = std::numbers::pi / 6;
  const auto pose = nudged(level, by);
  const Eigen::Vector3d ahead = pose.rotation.col(2);
  EXPECT_TRUE(ahead.isApprox(Eigen::Vector3d(0, 0.5, -std::cos(std::numbers::pi / 6))));
  EXPECT_TRUE(pose.rotation.col(0).isApprox(Eigen::Vector3d(1, 0, 0)));
}

}  // namespace
}  // namespace roomcast::client
