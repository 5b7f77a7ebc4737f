// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/calibration/ros_camera_info.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::alignment::calibration {
namespace {

const std::string kFile = R"(image_width: 640
image_height: 480
camera_name: rgb
camera_matrix:
  rows: 3
  cols: 3
  data: [525.5, 0, 319.1, 0, 524.25, 242.75, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [0.11, -0.22, 0.0013, -0.0004, 0.05]
)";

std::string with(const std::string& from, const std::string& to) {
  std::string text = kFile;
  return text.replace(text.find(from), from.size(), to);
}

TEST(RosCameraInfo, holds_size_lens_and_distortion) {
  const auto camera = parse_camera_info(kFile);
  ASSERT_TRUE(camera.ok()) << camera.error().message;
  const CameraIntrinsics expected{640,  480,   525.5, 524.25, 319.1,  242.75,
                                  0.11, -0.22, 0.05,  0.0013, -0.0004};
  EXPECT_EQ(*camera, expected);
}

TEST(RosCameraInfo, what_is_missing_or_no_number_is_refused) {
  for (const std::string& broken :
       {with("image_width: 640", ""), with("525.5", "wide"), with(", 0.05]", "]"),
        with("camera_matrix", "matrix"), std::string("[[["), std::string(), std::string("7"),
        std::string(20'000, '[')}) {
    EXPECT_EQ(parse_camera_info(broken).error().code, ErrorCode::kMalformed)
        << broken.substr(0, 40);
  }
  EXPECT_FALSE(parse_camera_info(with("525.5", "-1")).ok());
  EXPECT_FALSE(parse_camera_info(with("image_width: 640", "image_width: 99999")).ok());
}

TEST(RosCameraInfo, other_lens_models_are_named) {
  const auto refused = parse_camera_info(with("plumb_bob", "equidistant"));
  EXPECT_EQ(refused.error().code, ErrorCode::kUnsupported);
  EXPECT_THAT(refused.error().message, testing::HasSubstr("equidistant"));
}

TEST(RosCameraInfo, a_file_that_is_not_there_is_not_found) {
  EXPECT_EQ(read_camera_info("/nowhere/color.yaml").error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::alignment::calibration
