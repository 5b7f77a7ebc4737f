// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/pose_message.h"

#include <utility>

#include <gtest/gtest.h>

#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

TEST(PoseMessage, a_transform_is_read_as_it_was_written) {
  const RigidTransform pose = world_from_optical_looking_at({1, 2, 3}, {-0.3, 0.7, 9});
  google::protobuf::RepeatedField<double> row_major;
  write_transform(pose, row_major);
  EXPECT_EQ(exact_transform(row_major).rotation, pose.rotation);
  EXPECT_EQ(exact_transform(row_major).translation_m, pose.translation_m);
  const auto read = read_transform(row_major);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_TRUE(read->rotation.isApprox(pose.rotation, 1e-12));
}

TEST(PoseMessage, numbers_that_are_no_transform_are_refused) {
  google::protobuf::RepeatedField<double> row_major;
  EXPECT_EQ(read_transform(row_major).error().code, ErrorCode::kMalformed);
  row_major.Resize(16, 1.0);
  EXPECT_EQ(read_transform(row_major).error().code, ErrorCode::kMalformed);
}

SensorPose sensor_pose(PoseSource source, PoseState state) {
  return {RigidTransform{Eigen::Matrix3d::Identity(), {1, 2, 3}}, source, state, 0, "why"};
}

TEST(PoseMessage, every_source_and_state_survives_the_roster) {
  using Source = PoseSource;
  using State = PoseState;
  for (const auto& [source, state] :
       {std::pair(Source::kNone, State::kNone), std::pair(Source::kNone, State::kMoved),
        std::pair(Source::kGiven, State::kValid), std::pair(Source::kGiven, State::kMoved),
        std::pair(Source::kEstimated, State::kValid), std::pair(Source::kEstimated, State::kMoved),
        std::pair(Source::kStored, State::kUnverified),
        std::pair(Source::kStored, State::kMoved)}) {
    pb::SensorEntry entry;
    write_pose(sensor_pose(source, state), entry);
    const auto read = read_pose(entry);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->source, source);
    EXPECT_EQ(read->state, state);
    EXPECT_EQ(read->note, "why");
    EXPECT_EQ(read->world_from_depth.translation_m.z(), 3);
  }
}

TEST(PoseMessage, only_an_estimated_pose_has_an_expected_error) {
  SensorPose pose = sensor_pose(PoseSource::kEstimated, PoseState::kValid);
  pose.expected_error_mm = 4;
  pb::SensorEntry entry;
  write_pose(pose, entry);
  EXPECT_EQ(read_pose(entry)->expected_error_mm, 4);
  entry.set_placement(pb::PLACEMENT_GIVEN);
  EXPECT_EQ(read_pose(entry)->expected_error_mm, 0);
}

TEST(PoseMessage, a_roster_entry_without_a_transform_is_refused) {
  EXPECT_EQ(read_pose(pb::SensorEntry()).error().code, ErrorCode::kMalformed);
}

TEST(PoseMessage, an_aligners_result_is_read_as_it_was_written) {
  SensorPose pose = sensor_pose(PoseSource::kEstimated, PoseState::kValid);
  pose.expected_error_mm = 4;
  pb::SensorPlacement placement;
  write_pose(pose, placement);
  EXPECT_EQ(read_pose(placement).source, PoseSource::kEstimated);
  EXPECT_EQ(read_pose(placement).state, PoseState::kValid);
  EXPECT_EQ(read_pose(placement).expected_error_mm, 4);
  EXPECT_EQ(read_pose(placement).world_from_depth.translation_m.y(), 2);
}

TEST(PoseMessage, an_aligners_refusal_has_its_reason_and_no_pose) {
  SensorPose pose;
  pose.note = std::string(2 * kMaxNoteBytes, 'x');
  pb::SensorPlacement placement;
  write_pose(pose, placement);
  EXPECT_TRUE(placement.world_from_depth().empty());
  EXPECT_FALSE(read_pose(placement).is_placed());
  EXPECT_EQ(read_pose(placement).note.size(), kMaxNoteBytes);
}

TEST(PoseMessage, a_factor_on_readings_travels_with_the_pose) {
  SensorPose pose{.source = PoseSource::kEstimated, .state = PoseState::kValid};
  pose.depth_scale = 1.04;
  pb::SensorEntry entry;
  write_pose(pose, entry);
  EXPECT_EQ(read_pose(entry)->depth_scale, 1.04);
  pb::SensorPlacement placement;
  write_pose(pose, placement);
  EXPECT_EQ(read_pose(placement).depth_scale, 1.04);
}

TEST(PoseMessage, an_entry_without_a_factor_means_one) {
  SensorPose pose;
  pb::SensorEntry entry;
  write_pose(pose, entry);
  EXPECT_EQ(entry.depth_scale(), 0) << "as earlier hubs wrote it";
  EXPECT_EQ(read_pose(entry)->depth_scale, 1);
}

}  // namespace
}  // namespace roomcast::wire
