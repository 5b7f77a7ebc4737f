// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/doctor/pictures.h"

namespace roomcast::doctor {
namespace {

TEST(DoctorPictures, a_driver_in_software_is_noticed) {
  EXPECT_EQ(judge_graphics("llvmpipe (LLVM 15.0.6, 256 bits), 4.5").verdict, Verdict::kNotice);
  EXPECT_EQ(judge_graphics("NVIDIA GeForce RTX 3060/PCIe/SSE2, 4.6.0").verdict, Verdict::kOk);
}

TEST(DoctorPictures, a_context_can_be_made_here) {
  EXPECT_NE(check_graphics().verdict, Verdict::kProblem) << check_graphics().sentence;
}

TEST(DoctorPictures, windows_need_one_display_of_either_kind) {
  EXPECT_EQ(judge_display("wayland-0", "").verdict, Verdict::kOk);
  EXPECT_EQ(judge_display("", ":0").verdict, Verdict::kOk);
  EXPECT_EQ(judge_display("", "").verdict, Verdict::kNotice);
}

TEST(DoctorPictures, a_named_runtime_is_the_only_one_that_counts) {
  EXPECT_EQ(openxr_runtime_files("/opt/xr.json", "/c", "/home/ada"),
            std::vector<std::filesystem::path>{"/opt/xr.json"});
  EXPECT_EQ(openxr_runtime_files("", "", "/home/ada").front(),
            "/home/ada/.config/openxr/1/active_runtime.json");
  EXPECT_EQ(openxr_runtime_files("", "/c", "/home/ada").front(), "/c/openxr/1/active_runtime.json");
}

TEST(DoctorPictures, browsers_are_found_by_the_path) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "doctor_browsers";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "firefox") << "";
  EXPECT_EQ(find_browser("/nowhere::" + folder.string()), folder / "firefox");
  EXPECT_EQ(find_browser("/nowhere"), std::nullopt);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace roomcast::doctor
