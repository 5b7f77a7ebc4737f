// SPDX-License-Identifier: Apache-2.0
#include "roomcast/doctor/cameras.h"

#include <gtest/gtest.h>

namespace roomcast::doctor {
namespace {

bool is_freenect(const std::string& kind) {
  return kind == "freenect";
}

TEST(DoctorCameras, without_a_camera_the_simulator_is_named) {
  const auto findings = judge_cameras({}, is_freenect);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].verdict, Verdict::kNotice);
  EXPECT_NE(findings[0].remedy.find("roomcast demo"), std::string::npos);
}

TEST(DoctorCameras, a_kind_that_is_not_built_in_is_a_problem) {
  const auto findings = judge_cameras(
      {{.kind = "k4a", .model = "Azure Kinect", .serial = "7", .node = {}}}, is_freenect);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].verdict, Verdict::kProblem);
  EXPECT_NE(findings[0].sentence.find("Azure Kinect (7)"), std::string::npos);
}

TEST(DoctorCameras, a_camera_that_this_user_may_not_open_is_a_problem_with_a_remedy) {
  const auto findings = judge_cameras({{.kind = "freenect",
                                        .model = "Kinect v1",
                                        .serial = "",
                                        .node = "/nowhere/bus/usb/001/005"}},
                                      is_freenect);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].verdict, Verdict::kProblem);
  EXPECT_NE(findings[0].remedy, "");
}

}  // namespace
}  // namespace roomcast::doctor
