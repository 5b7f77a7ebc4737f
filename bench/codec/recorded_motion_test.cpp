// SPDX-License-Identifier: Apache-2.0
// Which recorded sensors count as carried, where recordings are available (ROOMCAST_DATA). Numbers
// of frames are at 30 frames a second.
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/codec/sensor_motion.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::bench {
namespace {

constexpr int kMaxRecordedFrames = 60;
constexpr int kFifthOfASecond = 6;

class RecordedMotion : public testing::Test {
 protected:
  void SetUp() override {
    const char* named = std::getenv("ROOMCAST_DATA");
    folder_ = named ? named : std::filesystem::path(ROOMCAST_SOURCE_DIR) / "../shared/data";
    if (!std::filesystem::exists(folder_ / "README.md")) {
      GTEST_SKIP() << "no recordings at " << folder_ << "; set ROOMCAST_DATA to test with them";
    }
  }
  /// The first frames of "rig:NAME#sensor" or "tum:NAME".
  [[nodiscard]] std::vector<DepthImage> frames_of(const std::string& kind,
                                                  const std::string& name) const {
    auto source = sensor::open_source(kind + ":" + (folder_ / name).string(),
                                      {.pace = source::Pace::kAsFastAsPossible, .loop = false});
    EXPECT_TRUE(source.ok()) << source.error().message;
    std::vector<DepthImage> frames;
    source::CapturedFrame frame;
    while (frames.size() < kMaxRecordedFrames && (*source)->next(frame, {}).value()) {
      frames.push_back(frame.depth_mm);
    }
    return frames;
  }
  /// Index of the first of the frames with which the sensor counts as carried, or their number.
  static int frames_until_carried(codec::SensorMotion& motion,
                                  const std::vector<DepthImage>& frames) {
    int index = 0;
    for (const DepthImage& frame : frames) {
      if (motion.update(frame)) break;
      ++index;
    }
    return index;
  }

  std::filesystem::path folder_;
};

TEST_F(RecordedMotion, fixed_sensors_are_never_carried) {
  for (const std::string name : {"kinects3#s0", "kinects3#s1", "kinects3#s2", "xtions2#s0",
                                 "xtions2#s1", "house3#s0", "house3#s1", "house3#s2"}) {
    const auto frames = frames_of("rig", name);
    codec::SensorMotion motion;
    ASSERT_GE(frames.size(), 8u) << name;
    EXPECT_EQ(frames_until_carried(motion, frames), static_cast<int>(frames.size())) << name;
  }
  codec::SensorMotion motion;
  EXPECT_EQ(frames_until_carried(motion, frames_of("tum", "kinect1_oni_fixed")), 12);
}

TEST_F(RecordedMotion, a_carried_sensor_is_noticed_within_a_fifth_of_a_second) {
  codec::SensorMotion motion;
  EXPECT_LE(frames_until_carried(motion, frames_of("tum", "redkitchen_moving")), kFifthOfASecond);
}

TEST_F(RecordedMotion, a_sensor_that_stood_before_is_noticed_as_fast) {
  const auto kitchen = frames_of("tum", "redkitchen_moving");
  codec::SensorMotion motion;
  const auto fixed = frames_of("rig", "kinects3#s0");
  ASSERT_EQ(frames_until_carried(motion, fixed), static_cast<int>(fixed.size()));
  EXPECT_LE(frames_until_carried(motion, kitchen), kFifthOfASecond);
}

TEST(SimulatedMotion, people_who_exercise_are_no_carried_sensor_at_a_few_frames_a_second) {
  auto source = sensor::open_source(
      "sim:studio#0",
      {.pace = source::Pace::kAsFastAsPossible, .sim_fps = 5, .sim_sensor_count = 3});
  ASSERT_TRUE(source.ok()) << source.error().message;
  codec::SensorMotion motion;
  source::CapturedFrame frame;
  for (int i = 0; i < 30; ++i) {
    ASSERT_TRUE((*source)->next(frame, {}).value());
    EXPECT_FALSE(motion.update(frame.depth_mm)) << i;
  }
}

}  // namespace
}  // namespace roomcast::bench
