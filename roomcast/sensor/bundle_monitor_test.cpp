// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/bundle_monitor.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"

namespace roomcast::sensor {
namespace {

using namespace std::chrono_literals;

/// A sensor that sees a synthetic room, ten times a second.
class Sensor {
 public:
  explicit Sensor(const RigidTransform& world_from_depth)
      : bundle_("s0", alignment::calibration_fixture()) {
    stand(world_from_depth);
  }
  void stand(const RigidTransform& world_from_depth) {
    const auto seen = alignment::bundle_fixture({}, "s0", world_from_depth);
    frame_.depth_mm = seen.depth_mm;
    frame_.color = seen.color;
  }
  void cover() { frame_.color = ColorImage(frame_.color.width(), frame_.color.height()); }

  BundleUpdate news() {
    frame_.capture_time += 100ms;
    auto news = bundle_.add(frame_);
    if (news) return *std::move(news);
    complaint = news.error().message;
    return {};
  }
  /// The combined updates of `frames` frames.
  BundleUpdate news_of(int frames) {
    BundleUpdate all;
    for (int i = 0; i < frames; ++i) {
      BundleUpdate one = news();
      all.moved |= one.moved;
      if (one.bundle) all.bundle = std::move(one.bundle);
    }
    return all;
  }

  std::string complaint;

 private:
  source::CapturedFrame frame_;
  BundleMonitor bundle_;
};

constexpr int kBundle = static_cast<int>(alignment::kBundleFrames);

TEST(BundleMonitor, the_first_frames_make_a_bundle_and_it_holds) {
  Sensor sensor(alignment::corner_pose(2, 1.5));
  EXPECT_FALSE(sensor.news_of(kBundle - 1).bundle);
  EXPECT_TRUE(sensor.news().bundle);
  const auto later = sensor.news_of(60);
  EXPECT_FALSE(later.moved || later.bundle);
}

TEST(BundleMonitor, a_moved_sensor_reports_it_and_makes_another_bundle) {
  Sensor sensor(alignment::corner_pose(2, 1.5));
  const auto first = sensor.news_of(kBundle).bundle;
  sensor.stand(alignment::corner_pose(1.9, 1.4));
  const auto noticed = sensor.news_of(20);
  EXPECT_TRUE(noticed.moved);
  EXPECT_FALSE(noticed.bundle);
  const auto second = sensor.news_of(kBundle).bundle;
  ASSERT_TRUE(first && second);
  EXPECT_NE(first->depth(), second->depth());
  EXPECT_FALSE(sensor.news_of(60).moved) << "it stands where it stands now";
}

TEST(BundleMonitor, no_bundle_is_made_while_the_sensor_moves) {
  Sensor sensor(alignment::corner_pose(2, 1.5));
  EXPECT_TRUE(sensor.news_of(kBundle).bundle);
  double x = 2;
  for (int i = 0; i < 3 * kBundle; ++i) {
    sensor.stand(alignment::corner_pose(x -= 0.02, 1.5));
    EXPECT_FALSE(sensor.news().bundle);
  }
  EXPECT_TRUE(sensor.news_of(2 * kBundle).bundle) << "it stands still again";
}

TEST(BundleMonitor, a_failed_bundle_gives_its_reason_and_is_tried_again) {
  Sensor sensor(alignment::corner_pose(2, 1.5));
  sensor.cover();
  EXPECT_FALSE(sensor.news_of(kBundle).bundle);
  EXPECT_FALSE(sensor.complaint.empty());
  sensor.stand(alignment::corner_pose(2, 1.5));
  EXPECT_TRUE(sensor.news_of(kBundle).bundle);
}

}  // namespace
}  // namespace roomcast::sensor
