// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/sighting_detector.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"

namespace roomcast::sensor {
namespace {

using namespace std::chrono_literals;

const RigidTransform kStand = world_from_optical_looking_at({2, 1.9, 1.5}, {-0.6, 1.0, -0.3});

/// A frame with a person in the room.
source::CapturedFrame frame_with_person() {
  alignment::RoomFixture room;
  room.boxes.push_back({Eigen::Vector3d(-1.02, 0, 0.75), Eigen::Vector3d(-0.58, 1.55, 1.05)});
  room.boxes.push_back({Eigen::Vector3d(-0.88, 1.55, 0.82), Eigen::Vector3d(-0.72, 1.8, 0.98)});
  source::CapturedFrame frame;
  frame.depth_mm = alignment::depth_fixture(room, alignment::calibration_fixture().depth, kStand);
  return frame;
}

wire::pb::SightingRequest heads() {
  wire::pb::SightingRequest request;
  request.set_heads(true);
  return request;
}

class SightingDetectorTest : public testing::Test {
 protected:
  /// The heads sent in two seconds at 30 frames a second.
  int heads_told() {
    int told = 0;
    for (int i = 0; i < 60; ++i) {
      const auto message = sighting_detector.add(frame_, time_ += 33ms);
      if (message) told += message->heads_size();
    }
    return told;
  }
  SightingDetector sighting_detector;

 private:
  source::CapturedFrame frame_ = frame_with_person();
  RoomTime time_{1h};
};

TEST_F(SightingDetectorTest, without_a_request_it_reports_nothing) {
  sighting_detector.stand(alignment::bundle_fixture({}, "s0", kStand));
  EXPECT_EQ(heads_told(), 0);
}

TEST_F(SightingDetectorTest, heads_are_reported_while_they_are_requested) {
  sighting_detector.stand(alignment::bundle_fixture({}, "s0", kStand));
  sighting_detector.want(heads());
  const int told = heads_told();
  EXPECT_GE(told, 10);
  EXPECT_LE(told, 19);
  sighting_detector.want({});
  EXPECT_EQ(heads_told(), 0);
}

TEST_F(SightingDetectorTest, a_moved_sensor_reports_nothing) {
  sighting_detector.stand(alignment::bundle_fixture({}, "s0", kStand));
  sighting_detector.want(heads());
  sighting_detector.stand(std::nullopt);
  EXPECT_EQ(heads_told(), 0);
}

}  // namespace
}  // namespace roomcast::sensor
