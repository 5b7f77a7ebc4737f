// SPDX-License-Identifier: Apache-2.0
// Real recordings, if they are available (ROOMCAST_DATA): each opens and yields all its frames.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "roomcast/recording/dataset/recording.h"
#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::sensor {
namespace {

constexpr double kLargestJitter_s = 0.002 + 1e-6;  // of the time stamps (SOURCE.md); files round
const SourceOptions kFastAndOnce{.pace = source::Pace::kAsFastAsPossible, .loop = false};

struct Expected {
  const char* spec;  // @ stands for the data folder
  int frames;
  int with_color;
};

class SharedData : public testing::TestWithParam<Expected> {};

bool any_reading(const DepthImage& depth) {
  return std::any_of(depth.data(), depth.data() + depth.view().pixel_count(),
                     [](std::uint16_t mm) { return mm != 0; });
}

TEST_P(SharedData, opens_and_gives_its_frames) {
  if (!std::filesystem::exists(recording::shared_data() / "README.md")) {
    GTEST_SKIP() << "no recordings at " << recording::shared_data()
                 << "; set ROOMCAST_DATA to test with them";
  }
  std::string spec = GetParam().spec;
  spec.replace(spec.find('@'), 1, recording::shared_data().string());
  auto source = open_source(spec, kFastAndOnce);
  ASSERT_TRUE(source.ok()) << source.error().message;
  source::CapturedFrame frame;
  int frames = 0, with_color = 0;
  HostTime last = HostTime::min();
  while (frames < GetParam().frames) {
    const auto more = (*source)->next(frame, {});
    ASSERT_TRUE(more.ok()) << more.error().message;
    if (!*more) break;
    EXPECT_GT(frame.capture_time, last);
    last = frame.capture_time;
    EXPECT_TRUE(any_reading(frame.depth_mm));
    ++frames;
    with_color += frame.color.empty() ? 0 : 1;
  }
  EXPECT_EQ(frames, GetParam().frames);
  EXPECT_EQ(with_color, GetParam().with_color);
}

// Only the start of long recordings: decoding them completely would take seconds.
INSTANTIATE_TEST_SUITE_P(
    Folders, SharedData,
    testing::Values(Expected{"rig:@/house3#s0", 6, 6}, Expected{"rig:@/house3#s1", 6, 6},
                    Expected{"rig:@/house3#s2", 6, 6}, Expected{"tum:@/redkitchen_moving", 20, 20},
                    Expected{"tum:@/kinect1_oni_fixed", 12, 12},
                    Expected{"tum:@/realsense_d435_bag", 2, 1},
                    Expected{"tum:@/azurekinect_room", 2, 0},
                    Expected{"tum:@/azurekinect_ceiling", 2, 0},
                    Expected{"tum:@/slambook_home", 5, 5},
                    Expected{"tum:@/pcl_laptop_static", 3, 3}, Expected{"tum:@/pcl_office", 1, 1}),
    [](const auto& test) {
      std::string name = test.param.spec;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
      return name;
    });

TEST(SharedDataHouse, true_capture_times_are_those_of_the_truth) {
  const auto house = recording::shared_data() / "house3";
  if (!std::filesystem::exists(house / "truth/s0/times.txt")) {
    GTEST_SKIP() << "no recordings at " << recording::shared_data()
                 << "; set ROOMCAST_DATA to test with them";
  }
  for (const char* id : {"s0", "s1", "s2"}) {
    const auto recording = recording::read_rig_recording(house, id);
    ASSERT_TRUE(recording.ok()) << recording.error().message;
    std::ifstream truth(house / "truth" / id / "times.txt");
    std::string header;
    std::getline(truth, header);
    std::uint64_t index = 0;
    double depth_s = 0, color_s = 0;
    int dropped = 0;
    auto frame = recording->frames.begin();
    while (truth >> index >> depth_s >> color_s >> dropped) {
      if (dropped != 0) continue;
      ASSERT_NE(frame, recording->frames.end());
      EXPECT_EQ(frame->index, index);
      EXPECT_NEAR(1e-9 * double(frame->true_time.count()), depth_s, kLargestJitter_s);
      ++frame;
    }
    EXPECT_EQ(frame, recording->frames.end());
  }
}

}  // namespace
}  // namespace roomcast::sensor
