// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/pose_message.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace roomcast::wire
