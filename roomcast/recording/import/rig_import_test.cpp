// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/rig_import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/recording/bytes/byte_source.h"
#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/recording/dataset/rig_json.h"
#include "roomcast/recording/import/azure_kinect_file.h"
#include "roomcast/recording/import/azure_kinect_fixture.h"
#include "roomcast/recording/playback/recording_source.h"

namespace roomcast::recording {
namespace {

using Files = std::vector<std::unique_ptr<SensorFile>>;

Files files_of(const std::vector<AzureFixture>& all) {
  Files files;
  for (const AzureFixture& made : all) {
    auto file = read_azure_kinect_file(bytes_in_memory(azure_recording(made)), made.serial);
    EXPECT_TRUE(file.ok());
    files.push_back(*std::move(file));
  }
  return files;
}

RoomTimeline timeline_of(const Files& files) {
  std::vector<const SensorFileInfo*> infos;
  for (const auto& file : files) infos.push_back(&file->info());
  const auto line = join_clocks(infos);
  EXPECT_TRUE(line.ok());
  return line.ok() ? *line : RoomTimeline{};
}

TEST(RigImport, depth_colour_and_times_are_those_of_the_recordings) {
  const TemporaryFolder folder;
  AzureFixture a, b;
  a.serial = "a";
  b.serial = "b", b.color = "", b.date_s += 1, b.start_offset_us = 9'000'000;
  const Files files = files_of({a, b});
  std::uint64_t last = 0;
  const auto done = import_rig(folder / "rig", files, timeline_of(files),
                               {.names = {"left", "right"},
                                .source = "test",
                                .progress = [&](std::uint64_t at, std::uint64_t) { last = at; }},
                               {});
  ASSERT_TRUE(done.ok()) << done.error().message;
  EXPECT_EQ(last, 6U);
  EXPECT_EQ((*done)[0].frames, 3U);
  EXPECT_EQ((*done)[0].colors, 3U);
  EXPECT_EQ((*done)[1].colors, 0U);
  const source::PlaybackOptions once{source::Pace::kAsFastAsPossible, false};
  auto left = open_rig_source((folder / "rig").string(), "left", once);
  auto right = open_rig_source((folder / "rig").string(), "right", once);
  ASSERT_TRUE(left.ok() && right.ok());
  source::CapturedFrame l, r;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(*(*left)->next(l, {}));
    ASSERT_TRUE(*(*right)->next(r, {}));
    EXPECT_EQ(l.depth_mm.at(319, 280), azure_depth_mm(i, 319, 280));
    EXPECT_NEAR(l.color.at(5, 5).g, 40 + 30 * i, 2);
    EXPECT_TRUE(r.color.empty());
    EXPECT_EQ(l.device_time, files[0]->info().times[static_cast<std::size_t>(i)]);
    EXPECT_EQ(r.device_time, files[1]->info().times[static_cast<std::size_t>(i)]);
    const nanoseconds apart = r.capture_time - l.capture_time - std::chrono::seconds(1);
    EXPECT_LT(std::abs(apart.count()), 2'000);
  }
}

TEST(RigImport, jpeg_is_kept_byte_for_byte) {
  const TemporaryFolder folder;
  const Files files = files_of({AzureFixture{}});
  ASSERT_TRUE(
      import_rig(folder / "rig", files, timeline_of(files), {.names = {"a"}, .source = ""}, {})
          .ok());
  const std::string written = text_of(folder / "rig/a/rgb/000001.jpg");
  const auto recorded = azure_color("MJPG", 1);
  EXPECT_EQ(written, std::string(recorded.begin(), recorded.end()));
}

TEST(RigImport, a_stop_leaves_a_rig_that_can_be_played) {
  const TemporaryFolder folder;
  const Files files = files_of({AzureFixture{}});
  std::stop_source stop;
  const auto part =
      import_rig(folder / "rig", files, timeline_of(files),
                 {.names = {"a"},
                  .source = "",
                  .progress = [&](std::uint64_t, std::uint64_t) { stop.request_stop(); }},
                 stop.get_token());
  ASSERT_FALSE(part.ok());
  EXPECT_EQ(part.error().code, ErrorCode::kClosed);
  EXPECT_TRUE(open_rig_source((folder / "rig").string(), "a", {}).ok());
}

TEST(RigImport, nothing_is_overwritten) {
  const TemporaryFolder folder;
  put_text(folder / "important", "x");
  const Files files = files_of({AzureFixture{}});
  const auto refused =
      import_rig(folder.path(), files, timeline_of(files), {.names = {"a"}, .source = ""}, {});
  EXPECT_EQ(refused.error().code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::recording
