// SPDX-License-Identifier: Apache-2.0
// Runs against the API of OpenNI 2: a simulated camera from a test driver
// (tests/virtual_openni2.cpp), and files.
#include "roomcast/source/drivers/openni2/openni2_backend.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include <OpenNI.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/source/camera/camera_source.h"
#include "roomcast/source/drivers/openni2/openni2_session.h"
#include "roomcast/source/drivers/openni2/openni2_streams.h"

/// LeakSanitizer asks this. OpenNI does not free everything, and unloads the drivers that could
/// tell whose memory it was.
extern "C" int __lsan_is_turned_off();
extern "C" int __lsan_is_turned_off() {
  return 1;
}

namespace roomcast::source {
namespace {

namespace fs = std::filesystem;

class OpenNi2 : public testing::Test {
 protected:
  OpenNi2() { ::setenv("ROOMCAST_VIRTUAL_CAMERAS", folder_.path().c_str(), 1); }
  ~OpenNi2() override { ::unsetenv("ROOMCAST_VIRTUAL_CAMERAS"); }

  void unplug() { std::ofstream(folder_ / "unplugged"); }
  void plug_in() { fs::remove(folder_ / "unplugged"); }

  std::unique_ptr<FrameSource> open(const std::string& place, bool loop = true) {
    auto source = CameraSource::open(backend_, place, {.settings = {.loop = loop}});
    EXPECT_TRUE(source.ok()) << (source.ok() ? "" : source.error().message);
    return source.ok() ? std::move(*source) : nullptr;
  }

  /// Records the virtual camera's pictures with OpenNI itself.
  fs::path record(int frames) {
    fs::path file = folder_ / "recorded.oni";
    on_openni2_thread([&] {
      const OpenNi2Session session;
      openni::Device device;
      EXPECT_EQ(device.open("virtual://camera"), openni::STATUS_OK);
      openni::VideoStream depth, color;
      EXPECT_TRUE(make_openni2_stream(device, openni::SENSOR_DEPTH, depth).ok());
      EXPECT_TRUE(make_openni2_stream(device, openni::SENSOR_COLOR, color).ok());
      openni::Recorder recorder;
      recorder.create(file.c_str());
      recorder.attach(depth);
      recorder.attach(color, false);
      depth.start(), color.start(), recorder.start();
      openni::VideoFrameRef frame;
      for (int i = 0; i < frames; ++i) {
        depth.readFrame(&frame);
        color.readFrame(&frame);
      }
      frame.release();
      // OpenNI's recorder and a stream that still has pictures can wait for each other for ever.
      depth.stop(), color.stop();
      recorder.stop();
      recorder.destroy();
      depth.destroy(), color.destroy();
      device.close();
    });
    return file;
  }

  const TemporaryFolder folder_;
  std::shared_ptr<CameraBackend> backend_ = openni2_backend();
};

/// A word of the file's head, overwritten. Debian's OpenNI 2.2.0.33 dies of each: of SIGABRT,
/// SIGSEGV.
struct DamagedWord {
  std::size_t at;
  std::uint32_t value;
};
constexpr DamagedWord kDamagedWords[] = {{20, 0x7fffff00}, {132, 0xfbb230bb}, {196, 0x64ac5db9}};

void expect_virtual_camera(const CapturedFrame& frame) {
  ASSERT_EQ(frame.depth_mm.width(), 320);
  ASSERT_EQ(frame.color.width(), 320);
  EXPECT_EQ(frame.depth_mm.at(0, 0), 1000);
  EXPECT_EQ(frame.depth_mm.at(100, 50), 1200);
  EXPECT_EQ(frame.color.at(100, 50), (Rgb8{50, 50, 77}));
}

TEST_F(OpenNi2, a_camera_is_listed_with_its_serial_number) {
  const auto cameras = backend_->list();
  ASSERT_TRUE(cameras.ok()) << cameras.error().message;
  ASSERT_EQ(cameras->size(), 1U);
  EXPECT_EQ(cameras->front().serial, "VIRTUAL-7");
  EXPECT_EQ(cameras->front().model, "roomcast virtual camera");
  EXPECT_FALSE(cameras->front().obstacle);
}

TEST_F(OpenNi2, a_camera_gives_depth_in_millimetres_and_colour) {
  const auto source = open("VIRTUAL-7");
  ASSERT_TRUE(source);
  EXPECT_EQ(source->description().name, "openni2-VIRTUAL-7");
  CapturedFrame frame;
  ASSERT_TRUE(*source->next(frame, {}));
  expect_virtual_camera(frame);
}

TEST_F(OpenNi2, a_camera_that_lays_depth_over_colour_is_asked_to_and_its_lens_follows_its_view) {
  const auto source = open("");
  ASSERT_TRUE(source);
  const SensorCalibration& cameras = source->description().calibration;
  EXPECT_TRUE(cameras.color_is_registered);
  EXPECT_NEAR(cameras.depth.fx, 160 / std::tan(0.5 * 1.0145), 0.01);
  EXPECT_DOUBLE_EQ(cameras.depth.cx, 159.5);
  EXPECT_DOUBLE_EQ(source->description().fps, 30);
}

TEST_F(OpenNi2, a_camera_that_is_unplugged_and_plugged_in_again_goes_on) {
  const auto source = open("VIRTUAL-7");
  ASSERT_TRUE(source);
  CapturedFrame frame;
  ASSERT_TRUE(*source->next(frame, {}));
  unplug();
  while (source->health().is_connected) std::this_thread::yield();
  plug_in();
  ASSERT_TRUE(*source->next(frame, {}));
  ASSERT_TRUE(*source->next(frame, {}));  // the first one may be from before
  expect_virtual_camera(frame);
  EXPECT_EQ(source->health().disconnect_count, 1U);
}

TEST_F(OpenNi2, a_recorded_file_plays_to_its_end) {
  const fs::path file = record(30);
  unplug();
  const auto source = open(file, false);
  ASSERT_TRUE(source);
  CapturedFrame frame;
  int frames = 0;
  while (*source->next(frame, {})) {
    expect_virtual_camera(frame);
    ++frames;
  }
  // Of 30 frames: OpenNI's recorder leaves out what it has no time for on a busy machine, and its
  // player skips what is not taken in time.
  EXPECT_GE(frames, 3);
}

TEST_F(OpenNi2, a_missing_or_invalid_file_is_named) {
  const auto open_file = [&](const fs::path& file) {
    return CameraSource::open(backend_, file, {}).error();
  };
  EXPECT_EQ(open_file(folder_ / "absent.oni").code, ErrorCode::kNotFound);
  std::ofstream(folder_ / "broken.oni") << "not a recording";
  EXPECT_EQ(open_file(folder_ / "broken.oni").code, ErrorCode::kUnavailable);
}

TEST_F(OpenNi2, a_damaged_file_that_crashes_openni_ends_with_a_reason) {
  const fs::path whole = record(4);
  std::ifstream in(whole, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  ASSERT_GT(bytes.size(), 1000U);
  for (const DamagedWord& word : kDamagedWords) {
    std::string damaged = bytes;
    std::memcpy(damaged.data() + word.at, &word.value, sizeof(word.value));
    const fs::path file = folder_ / "damaged.oni";
    std::ofstream(file, std::ios::binary) << damaged;
    const auto source = CameraSource::open(backend_, file, {.settings = {.loop = false}});
    Result<bool> more = source.ok() ? Result<bool>(true) : Result<bool>(source.error());
    CapturedFrame frame;
    while (more && *more) more = (*source)->next(frame, {});
    ASSERT_FALSE(more.ok()) << word.at;
    EXPECT_EQ(more.error().code, ErrorCode::kMalformed);
    EXPECT_THAT(more.error().message, testing::AllOf(testing::HasSubstr("damaged.oni is damaged"),
                                                     testing::HasSubstr("broke off")));
  }
}

TEST_F(OpenNi2, a_file_that_is_cut_plays_up_to_there) {
  const fs::path file = record(6);
  fs::resize_file(file, fs::file_size(file) / 2);
  const auto source = CameraSource::open(backend_, file, {.settings = {.loop = false}});
  CapturedFrame frame;
  while (source.ok()) {
    const auto more = (*source)->next(frame, {});
    if (!more || !*more) break;
    expect_virtual_camera(frame);
  }
}

TEST_F(OpenNi2, without_a_camera_there_is_none) {
  unplug();
  EXPECT_TRUE(backend_->list()->empty());
  EXPECT_EQ(CameraSource::open(backend_, "", {}).error().code, ErrorCode::kNotFound);
}

TEST_F(OpenNi2, a_recording_of_a_real_kinect_plays) {
  const char* const data = std::getenv("ROOMCAST_DATA");
  const fs::path file = fs::path(data != nullptr ? data : ROOMCAST_SOURCE_DIR "/../shared/data") /
                        "kinect1_oni_fixed/test.oni";
  if (!fs::exists(file))
    GTEST_SKIP() << "no recording at " << file << "; set ROOMCAST_DATA to test with it";
  const auto source = open(file);
  ASSERT_TRUE(source);
  CapturedFrame frame;
  ASSERT_TRUE(*source->next(frame, {}));
  EXPECT_EQ(frame.depth_mm.width(), 640);
  EXPECT_EQ(frame.color.width(), 640);
  int readings = 0;
  for (int i = 0; i < 640 * 480; ++i) readings += frame.depth_mm.data()[i] > 0;
  EXPECT_GT(readings, 640 * 480 / 2);
  EXPECT_NEAR(source->description().calibration.depth.fx, 575.8, 0.2);
  EXPECT_TRUE(source->description().calibration.color_is_registered);
}

}  // namespace
}  // namespace roomcast::source
