// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/align/recorded_alignment.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/recording/dataset/recording_fixture.h"

namespace roomcast::recording {
namespace {

Result<alignment::AlignmentReport> align_quietly(const std::filesystem::path& rig) {
  return align_recording(rig, "auto", {}, [](const std::string&) {});
}

TEST(RecordedRig, sensors_that_show_too_little_are_in_the_report_with_the_reason) {
  const TemporaryFolder folder;
  const auto report = align_quietly(write_small_rig(folder, 8));
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_EQ(report->sensors.size(), 2u);
  for (const alignment::SensorReport& sensor : report->sensors) {
    EXPECT_FALSE(sensor.world_from_depth.has_value()) << sensor.id;
    EXPECT_FALSE(sensor.reason.empty()) << sensor.id;
  }
}

TEST(RecordedRig, tells_which_sensor_it_reads) {
  const TemporaryFolder folder;
  std::vector<std::string> told;
  const auto report = align_recording(write_small_rig(folder, 8), "auto", {},
                                      [&](const std::string& what) { told.push_back(what); });
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(std::ranges::count(told, "reading s0"), 1);
  EXPECT_EQ(std::ranges::count(told, "reading s1"), 1);
}

TEST(RecordedRig, a_folder_that_is_none_and_a_damaged_one_are_told_apart) {
  const TemporaryFolder folder;
  EXPECT_EQ(align_quietly(folder / "nothing").error().code, ErrorCode::kNotFound);
  const auto rig = write_small_rig(folder);
  put_text(rig / "rig.json", "{");
  EXPECT_EQ(align_quietly(rig).error().code, ErrorCode::kMalformed);
}

}  // namespace
}  // namespace roomcast::recording
