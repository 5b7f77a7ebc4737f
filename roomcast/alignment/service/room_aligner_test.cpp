// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/room_aligner.h"

#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"
#include "roomcast/alignment/service/bundle_message.h"
#include "roomcast/client/publisher.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/hub/server/running_hub.h"

namespace roomcast::alignment {
namespace {

using namespace std::chrono_literals;

class RoomAlignerTest : public testing::Test {
 protected:
  std::unique_ptr<client::Publisher> add_sensor(const std::string& name,
                                                const RigidTransform& world_from_depth) {
    const auto bundle = alignment::bundle_fixture({}, name, world_from_depth);
    client::PublisherOptions options;
    options.hub_url = hub_.url();
    options.name = name;
    options.calibration = bundle.calibration;
    auto publisher = *client::Publisher::open(options);
    publisher->send_bundle(*message_from_bundle(bundle));
    return publisher;
  }

  const hub::RunningHub hub_;
};

TEST_F(RoomAlignerTest, sensors_of_a_running_room_are_placed) {
  const auto first_pose = alignment::corner_pose(2, 1.5),
             second_pose = alignment::corner_pose(-2, 1.5);
  const auto first = add_sensor("left", first_pose);
  const auto aligner = RoomAligner::open(
      {.hub_url = hub_.url(), .room = {}, .token = hub_.server().own_token(), .log = {}});
  ASSERT_TRUE(aligner.ok()) << aligner.error().message;
  const auto second = add_sensor("right", second_pose);

  const auto viewer =
      *client::Subscriber::open({.hub_url = hub_.url(), .room = {}, .name = {}, .log = {}});
  const auto both_placed = [&] {
    const auto room = viewer->snapshot();
    return room->sensors.size() == 2 && room->sensors[0].pose.is_placed() &&
           room->sensors[1].pose.is_placed();
  };
  const auto give_up = std::chrono::steady_clock::now() + 50s;
  while (!both_placed() && std::chrono::steady_clock::now() < give_up) {
    std::this_thread::sleep_for(20ms);
  }
  ASSERT_TRUE(both_placed());
  const auto room = viewer->snapshot();
  const RigidTransform found =
      room->sensors[0].pose.world_from_depth.inverse() * room->sensors[1].pose.world_from_depth;
  const RigidTransform truth = first_pose.inverse() * second_pose;
  EXPECT_LT((found.translation_m - truth.translation_m).norm(), 0.02);
  EXPECT_GT(room->sensors[0].pose.world_from_depth.translation_m.y(), 1.5) << "the floor is at 0";
}

TEST_F(RoomAlignerTest, an_aligner_without_a_token_places_nothing) {
  std::atomic<bool> refused = false;
  const auto aligner = RoomAligner::open({.hub_url = hub_.url(),
                                          .room = {},
                                          .token = "guessed",
                                          .log = [&](LogLevel level, std::string_view) {
                                            if (level == LogLevel::kError) refused = true;
                                          }});
  ASSERT_TRUE(aligner.ok());
  const auto give_up = std::chrono::steady_clock::now() + 5s;
  while (!refused && std::chrono::steady_clock::now() < give_up) std::this_thread::sleep_for(5ms);
  EXPECT_TRUE(refused);
}

}  // namespace
}  // namespace roomcast::alignment
