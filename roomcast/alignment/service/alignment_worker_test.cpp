// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/alignment_worker.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"
#include "roomcast/alignment/service/bundle_message.h"
#include "roomcast/alignment/service/known_room_fixture.h"
#include "roomcast/core/blocking_queue.h"

namespace roomcast::alignment {
namespace {

const RigidTransform kLeftSensor = alignment::corner_pose(2, 1.5),
                     kRightSensor = alignment::corner_pose(-2, 1.5);

class AlignmentWorkerTest : public testing::Test {
 protected:
  void add(const std::string& sensor, const RigidTransform& world_from_depth,
           std::uint32_t number) {
    const auto bundle = alignment::bundle_fixture({}, sensor, world_from_depth);
    auto message = *message_from_bundle(bundle);
    message.set_number(number);
    alignment_worker.add(sensor, bundle.calibration, std::move(message));
  }
  static const Placement* find(const AlignmentUpdate& update, const std::string& sensor) {
    for (const Placement& placement : update.placements) {
      if (placement.sensor == sensor) return &placement;
    }
    return nullptr;
  }

  BlockingQueue<AlignmentUpdate> updates{16};
  AlignmentWorker alignment_worker{
      [this](AlignmentUpdate update) { (void)updates.push(std::move(update), {}); }};
};

TEST_F(AlignmentWorkerTest, bundles_that_come_together_are_one_update_with_their_numbers) {
  alignment_worker.set_known({}, true);
  add("left", kLeftSensor, 4);
  add("right", kRightSensor, 7);
  const auto update = updates.pop({});
  ASSERT_TRUE(update);
  ASSERT_TRUE(find(*update, "left") && find(*update, "right"));
  EXPECT_TRUE(find(*update, "right")->pose.is_placed());
  EXPECT_EQ(find(*update, "left")->bundle_number, 4U);
  EXPECT_EQ(find(*update, "right")->bundle_number, 7U);
  EXPECT_FALSE(update->wanted.heads());
}

TEST_F(AlignmentWorkerTest, a_guess_is_answered_though_nobody_is_lost) {
  add("left", kLeftSensor, 1);
  add("right", kRightSensor, 1);
  alignment_worker.set_known(given_room({{"left", kLeftSensor}}), false);
  RigidTransform guess = kRightSensor;
  guess.translation_m.x() += 0.1;
  alignment_worker.nudge("right", guess);
  const auto update = updates.pop({});
  ASSERT_TRUE(update && find(*update, "right"));
  ASSERT_TRUE(find(*update, "right")->pose.is_placed()) << find(*update, "right")->pose.note;
  EXPECT_LT(
      (find(*update, "right")->pose.world_from_depth.translation_m - kRightSensor.translation_m)
          .norm(),
      0.03);
}

}  // namespace
}  // namespace roomcast::alignment
