// SPDX-License-Identifier: Apache-2.0
// Runs against the API of libfreenect, implemented by the library that replays recordings
// (tests/virtual_freenect.cpp).
#include "roomcast/source/drivers/freenect/freenect_backend.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/source/camera/camera_source.h"
#include "roomcast/source/drivers/freenect/fakenect_fixture.h"
#include "roomcast/source/drivers/freenect/kinect_depth.h"

namespace roomcast::source {
namespace {

namespace fs = std::filesystem;

class ReplayedKinect : public testing::Test {
 protected:
  ReplayedKinect() {
    write_fakenect_recording(folder_.path(), 10);
    ::setenv("FAKENECT_PATH", folder_.path().c_str(), 1);
  }

  void unplug() { std::ofstream(folder_ / "unplugged"); }
  void plug_in() { fs::remove(folder_ / "unplugged"); }

  std::unique_ptr<FrameSource> open(const std::string& place) {
    auto source = CameraSource::open(backend_, place, {});
    EXPECT_TRUE(source.ok()) << (source.ok() ? "" : source.error().message);
    return source.ok() ? std::move(*source) : nullptr;
  }

  const TemporaryFolder folder_;
  std::shared_ptr<CameraBackend> backend_ = freenect_backend();
};

TEST_F(ReplayedKinect, is_listed_with_its_serial_number_and_capabilities) {
  const auto cameras = backend_->list();
  ASSERT_TRUE(cameras.ok()) << cameras.error().message;
  ASSERT_EQ(cameras->size(), 1U);
  EXPECT_EQ(cameras->front().serial, "A00367813501053A");
  EXPECT_TRUE(backend_->abilities().lock_exposure);
  EXPECT_FALSE(backend_->abilities().sync);
}

TEST_F(ReplayedKinect, gives_depth_in_millimetres_and_colour) {
  const auto source = open("0");
  ASSERT_TRUE(source);
  EXPECT_EQ(source->description().name, "freenect-A00367813501053A");
  CapturedFrame frame;
  ASSERT_TRUE(*source->next(frame, {}));
  const auto mm = kinect_mm_from_raw({});
  for (const auto& [x, y] : {std::pair{64, 0}, {320, 240}, {639, 479}}) {
    EXPECT_EQ(frame.depth_mm.at(x, y), mm[recorded_raw(x, y)]);
    EXPECT_EQ(frame.color.at(x, y), recorded_color(x, y));
  }
  EXPECT_EQ(frame.depth_mm.at(0, 0), 0);
}

TEST_F(ReplayedKinect, frames_are_a_thirtieth_of_a_second_apart_by_its_own_clock) {
  const auto source = open("0");
  ASSERT_TRUE(source);
  CapturedFrame first, second;
  ASSERT_TRUE(*source->next(first, {}));
  ASSERT_TRUE(*source->next(second, {}));
  const double periods =
      double((second.device_time - first.device_time).count()) * 1e-9 * kRecordedFps;
  EXPECT_NEAR(periods, double(second.index - first.index), 0.001);
}

TEST_F(ReplayedKinect, its_cameras_come_from_its_memory) {
  const auto source = open("A00367813501053A");
  ASSERT_TRUE(source);
  const SensorCalibration& cameras = source->description().calibration;
  EXPECT_NEAR(cameras.depth.fx, 575.8, 0.1);
  EXPECT_NEAR(cameras.color.fx, 525, 0.5);
  EXPECT_NEAR(cameras.color_from_depth.translation_m.x(), -0.025, 0.0002);
}

TEST_F(ReplayedKinect, that_is_unplugged_and_plugged_in_again_goes_on) {
  const auto source = open("0");
  ASSERT_TRUE(source);
  CapturedFrame frame;
  ASSERT_TRUE(*source->next(frame, {}));
  unplug();
  while (source->health().is_connected) std::this_thread::yield();
  plug_in();
  const auto before = frame.capture_time;
  ASSERT_TRUE(*source->next(frame, {}));
  ASSERT_TRUE(*source->next(frame, {}));  // the first one may be from before
  EXPECT_GT(frame.capture_time, before);
  EXPECT_EQ(source->health().disconnect_count, 1U);
}

TEST_F(ReplayedKinect, that_is_not_there_is_not_found) {
  EXPECT_EQ(CameraSource::open(backend_, "B0", {}).error().code, ErrorCode::kNotFound);
  unplug();
  EXPECT_EQ(CameraSource::open(backend_, "", {}).error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::source
