// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/lookout.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/made_up_room.h"

namespace roomcast::aligner {
namespace {

using namespace std::chrono_literals;

const RigidTransform kStand = world_from_optical_looking_at({2, 1.9, 1.5}, {-0.6, 1.0, -0.3});

/// Somebody stands in the room.
CapturedFrame frame_with_person() {
  align::MadeUpRoom room;
  room.boxes.push_back({Eigen::Vector3d(-1.02, 0, 0.75), Eigen::Vector3d(-0.58, 1.55, 1.05)});
  room.boxes.push_back({Eigen::Vector3d(-0.88, 1.55, 0.82), Eigen::Vector3d(-0.72, 1.8, 0.98)});
  CapturedFrame frame;
  frame.depth_mm = align::made_up_depth(room, align::made_up_calibration().depth, kStand);
  return frame;
}

wire::pb::SightingRequest heads() {
  wire::pb::SightingRequest request;
  request.set_heads(true);
  return request;
}

class LookoutTest : public testing::Test {
 protected:
  /// Heads told of in two seconds at 30 frames a second.
  int heads_told() {
    int told = 0;
    for (int i = 0; i < 60; ++i) {
      const auto message = lookout.add(frame_, time_ += 33ms);
      if (message) told += message->heads_size();
    }
    return told;
  }
  Lookout lookout;

 private:
  CapturedFrame frame_ = frame_with_person();
  RoomTime time_{1h};
};

TEST_F(LookoutTest, nobody_asks_nobody_is_told) {
  lookout.stand(align::made_up_bundle({}, "s0", kStand));
  EXPECT_EQ(heads_told(), 0);
}

TEST_F(LookoutTest, heads_are_told_of_while_they_are_asked_for) {
  lookout.stand(align::made_up_bundle({}, "s0", kStand));
  lookout.want(heads());
  const int told = heads_told();
  EXPECT_GE(told, 10);
  EXPECT_LE(told, 19);
  lookout.want({});
  EXPECT_EQ(heads_told(), 0);
}

TEST_F(LookoutTest, a_sensor_that_was_moved_tells_nothing) {
  lookout.stand(align::made_up_bundle({}, "s0", kStand));
  lookout.want(heads());
  lookout.stand(std::nullopt);
  EXPECT_EQ(heads_told(), 0);
}

}  // namespace
}  // namespace roomcast::aligner
