// SPDX-License-Identifier: Apache-2.0
#include "roomcast/doctor/computer.h"

#include <gtest/gtest.h>

namespace roomcast::doctor {
namespace {

constexpr std::uint64_t kGibibyte = std::uint64_t{1} << 30;

TEST(DoctorComputer, what_is_short_comes_with_a_remedy) {
  for (const Finding& finding :
       {judge_processor(1), judge_memory(kGibibyte / 2), judge_descriptors(256), judge_clock(false),
        judge_disk("/data", 5 * kGibibyte)}) {
    EXPECT_EQ(finding.verdict, Verdict::kNotice) << finding.topic;
    EXPECT_NE(finding.remedy, "") << finding.topic;
  }
}

TEST(DoctorComputer, what_suffices_needs_none) {
  for (const Finding& finding :
       {judge_processor(4), judge_memory(8 * kGibibyte), judge_descriptors(1024), judge_clock(true),
        judge_disk("/data", 100 * kGibibyte)}) {
    EXPECT_EQ(finding.verdict, Verdict::kOk) << finding.topic;
    EXPECT_EQ(finding.remedy, "") << finding.topic;
  }
}

TEST(DoctorComputer, a_full_disk_is_a_problem) {
  EXPECT_EQ(judge_disk("/data", kGibibyte / 2).verdict, Verdict::kProblem);
}

TEST(DoctorComputer, hours_of_recording_follow_from_the_space) {
  // 86.4 GB at 0.24 MB/s
  EXPECT_NE(judge_disk("/data", 86'400'000'000).sentence.find("100 hours"), std::string::npos);
}

TEST(DoctorComputer, reads_the_available_memory) {
  EXPECT_EQ(available_memory_bytes("MemTotal: 9 kB\nMemAvailable:    2048 kB\nBuffers: 1 kB\n"),
            2048U * 1024);
  EXPECT_EQ(available_memory_bytes("MemTotal: 9 kB\n"), std::nullopt);
  EXPECT_EQ(available_memory_bytes("MemAvailable: lots"), std::nullopt);
  EXPECT_EQ(available_memory_bytes("MemAvailable:"), std::nullopt);
}

TEST(DoctorComputer, looks_at_this_computer) {
  for (const Finding& finding :
       {check_processor(), check_memory(), check_descriptors(), check_clock(), check_disk()}) {
    EXPECT_NE(finding.topic, "");
    EXPECT_TRUE(finding.sentence.ends_with('.')) << finding.sentence;
  }
}

}  // namespace
}  // namespace roomcast::doctor
