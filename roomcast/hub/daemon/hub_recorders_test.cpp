// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_recorders.h"

#include <functional>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/hub/server/running_hub.h"
#include "roomcast/recording/room/room_recording.h"

namespace roomcast::hub::daemon {
namespace {

using namespace std::chrono_literals;
using hub::RecordingState;

class HubRecordersTest : public testing::Test {
 protected:
  HubRecordersTest() { own_.opened({.port = hub_.port()}, hub_.server().own_token()); }

  /// Waits until the state is neither starting nor stopping, and returns it.
  hub::RoomRecording settled() {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    for (;;) {
      const auto now = recorders_.now("room");
      const bool moves =
          now.state == RecordingState::kStarting || now.state == RecordingState::kStopping;
      if (!moves || std::chrono::steady_clock::now() > give_up) return now;
      std::this_thread::yield();
    }
  }

  TemporaryFolder folder_;
  const hub::RunningHub hub_;
  OwnHub own_;
  HubRecorders recorders_{own_, folder_.path() / "recordings", {}};
};

TEST_F(HubRecordersTest, each_recording_has_its_own_file) {
  for (const char* name : {"roomcast-room-0001.mcap", "roomcast-room-0002.mcap"}) {
    ASSERT_TRUE(recorders_.start("room", "Ada").ok());
    const auto on = settled();
    ASSERT_EQ(on.state, RecordingState::kOn) << on.problem;
    EXPECT_EQ(std::filesystem::path(on.file).filename(), name);
    ASSERT_TRUE(recorders_.stop("room").ok());
    const auto off = settled();
    EXPECT_EQ(off.state, RecordingState::kOff) << off.problem;
    EXPECT_GT(off.bytes, 0u);
    EXPECT_EQ(off.file, on.file);
    EXPECT_EQ(std::filesystem::file_size(off.file), off.bytes);
  }
}

TEST_F(HubRecordersTest, refuses_to_start_twice_or_stop_nothing) {
  EXPECT_FALSE(recorders_.stop("room").ok());
  ASSERT_TRUE(recorders_.start("room", "Ada").ok());
  EXPECT_FALSE(recorders_.start("room", "Ada").ok());
  ASSERT_EQ(settled().state, RecordingState::kOn);
  EXPECT_FALSE(recorders_.start("room", "Ada").ok());
}

TEST_F(HubRecordersTest, a_failed_recording_has_its_reason_and_can_be_restarted) {
  std::filesystem::create_directories(folder_.path());
  const auto in_the_way = folder_.path() / "recordings";
  std::filesystem::create_symlink("/dev/null/nowhere", in_the_way);
  ASSERT_TRUE(recorders_.start("room", "Ada").ok());
  const auto failed = settled();
  EXPECT_EQ(failed.state, RecordingState::kFailed);
  EXPECT_NE(failed.problem.find("recordings"), std::string::npos) << failed.problem;
  std::filesystem::remove(in_the_way);
  ASSERT_TRUE(recorders_.start("room", "Ada").ok());
  EXPECT_EQ(settled().state, RecordingState::kOn);
}

TEST_F(HubRecordersTest, an_unrecorded_room_has_no_recording) {
  EXPECT_EQ(recorders_.now("room").state, RecordingState::kOff);
  EXPECT_TRUE(recorders_.now("room").file.empty());
}

}  // namespace
}  // namespace roomcast::hub::daemon
