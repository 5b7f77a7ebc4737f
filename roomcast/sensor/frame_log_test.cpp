// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/frame_log.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

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

TEST(FrameLog, goes_on_in_a_file_that_is_there_if_wanted) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "frames.jsonl";
  const auto lines_after = [&](FrameLog::Start start) {
    auto log = FrameLog::open(path, start);
    EXPECT_TRUE(log.ok() && log->add(1, RoomTime(), DepthImage(2, 2)).ok());
    std::ifstream file(path);
    return std::count(std::istreambuf_iterator<char>(file), {}, '\n');
  };
  EXPECT_EQ(lines_after(FrameLog::Start::kAnew), 1);
  EXPECT_EQ(lines_after(FrameLog::Start::kAppended), 2);
  EXPECT_EQ(lines_after(FrameLog::Start::kAnew), 1);
}

}  // namespace
}  // namespace roomcast::sensor
