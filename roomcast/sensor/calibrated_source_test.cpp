// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/calibrated_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/io/camera_json.h"
#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::sensor {
namespace {

class Calibrated : public testing::Test {
 protected:
  std::unique_ptr<source::FrameSource> source() {
    auto opened = open_source("rig:" + rig_.string() + "#s0",
                              {.pace = source::Pace::kAsFastAsPossible, .loop = false});
    EXPECT_TRUE(opened.ok());
    return std::move(*opened);
  }
  std::filesystem::path write(const io::RecordedCamera& camera) {
    recording::put_text(folder_ / "better.json", io::camera_json_text(camera));
    return folder_ / "better.json";
  }

  TemporaryFolder folder_;
  const std::filesystem::path rig_ = recording::write_small_rig(folder_);
  io::RecordedCamera camera_{.calibration = recording::small_calibration()};
};

TEST_F(Calibrated, frames_come_with_the_files_cameras_and_corrected_depth) {
  camera_.calibration.depth.fx = 36.5;
  camera_.calibration.color_from_depth.translation_m.x() = -0.06;
  camera_.depth_scale_to_metre = 0.00101;
  camera_.depth_bias_m = -0.004;
  auto better = with_calibration(source(), write(camera_));
  ASSERT_TRUE(better.ok()) << better.error().message;
  EXPECT_DOUBLE_EQ((*better)->description().calibration.depth.fx, 36.5);
  EXPECT_DOUBLE_EQ((*better)->description().calibration.color_from_depth.translation_m.x(), -0.06);
  EXPECT_EQ((*better)->description().name, "s0");
  source::CapturedFrame frame;
  ASSERT_TRUE(*(*better)->next(frame, {}));
  EXPECT_EQ(recording::small_frame(0, 0).depth_mm.at(0, 0), 1000);
  EXPECT_EQ(frame.depth_mm.at(0, 0), 1006);
  EXPECT_FALSE(frame.color.empty());
}

TEST_F(Calibrated, a_file_for_another_camera_is_refused) {
  camera_.calibration.color.width = 81;
  const auto refused = with_calibration(source(), write(camera_));
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalidArgument);
  EXPECT_THAT(refused.error().message, testing::HasSubstr("81x60"));
  EXPECT_EQ(with_calibration(source(), folder_ / "absent.json").error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::sensor
