// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/file_source.h"

#include <gtest/gtest.h>

#include "roomcast/recording/bytes/byte_source.h"
#include "roomcast/recording/import/azure_kinect_file.h"
#include "roomcast/recording/import/azure_kinect_fixture.h"

namespace roomcast::recording {
namespace {

const source::PlaybackOptions kOnce{.pace = source::Pace::kAsFastAsPossible, .loop = false};

std::vector<std::unique_ptr<SensorFile>> two_files(AzureFixture first, AzureFixture second) {
  std::vector<std::unique_ptr<SensorFile>> files;
  for (const AzureFixture& made : {first, second}) {
    auto file = read_azure_kinect_file(bytes_in_memory(azure_recording(made)), made.serial);
    EXPECT_TRUE(file.ok());
    files.push_back(*std::move(file));
  }
  return files;
}

TEST(FileSource, two_recordings_play_on_one_timeline) {
  AzureFixture a, b;
  a.serial = "a", a.sync = "MASTER", a.color = "";
  b.serial = "b", b.sync = "SUBORDINATE", b.color = "";
  b.first_us = 110'000;
  auto room = play_together(two_files(a, b), kOnce);
  ASSERT_TRUE(room.ok()) << room.error().message;
  auto& sources = room->sources;
  source::CapturedFrame from_a, from_b;
  ASSERT_TRUE(*sources[0]->next(from_a, {}));
  ASSERT_TRUE(*sources[1]->next(from_b, {}));
  EXPECT_EQ(sources[0]->description().name, "a");
  EXPECT_EQ(from_a.depth_mm.at(1, 1), azure_depth_mm(0, 1, 1));
  EXPECT_EQ(from_b.capture_time - from_a.capture_time, std::chrono::milliseconds(10));
  EXPECT_EQ(from_b.device_time, std::chrono::microseconds(610'000));
  EXPECT_TRUE(*sources[0]->next(from_a, {}));
  EXPECT_EQ(from_a.index, 1U);
  EXPECT_TRUE(*sources[0]->next(from_a, {}));
  EXPECT_FALSE(*sources[0]->next(from_a, {}));
}

TEST(FileSource, a_loop_lasts_as_long_for_all) {
  AzureFixture a, b;
  a.serial = "a", a.sync = "MASTER", a.color = "";
  b.serial = "b", b.sync = "SUBORDINATE", b.color = "", b.frames = 2;
  auto room = play_together(two_files(a, b), {source::Pace::kAsFastAsPossible, true});
  ASSERT_TRUE(room.ok());
  auto& sources = room->sources;
  source::CapturedFrame frame;
  HostTime first{};
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(*sources[1]->next(frame, {}));
    if (i == 0) first = frame.capture_time;
  }
  EXPECT_NEAR(std::chrono::duration<double>(frame.capture_time - first).count(), 0.1, 1e-4);
}

TEST(FileSource, recordings_of_different_days_are_not_one_room) {
  AzureFixture a, b;
  a.serial = "a", a.color = "";
  b.serial = "b", b.color = "", b.date_s += 86'400;
  EXPECT_EQ(play_together(two_files(a, b), kOnce).error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace roomcast::recording
