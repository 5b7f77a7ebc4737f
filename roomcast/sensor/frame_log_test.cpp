// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/frame_log.h"

#include <gtest/gtest.h>

namespace roomcast::sensor {
namespace {

TEST(FrameLog, that_cannot_be_written_says_so_and_harms_nothing_else) {
  auto log = FrameLog::open("/dev/full");
  ASSERT_TRUE(log.ok()) << log.error().message;
  const DepthImage depth(4, 3);
  for (std::uint32_t seq = 0; seq < 1000; ++seq) {
    const Status added = log->add(seq, RoomTime{}, depth.view());
    ASSERT_FALSE(added.ok());
    EXPECT_EQ(added.error().code, ErrorCode::kUnavailable);
  }
}

}  // namespace
}  // namespace roomcast::sensor
