// SPDX-License-Identifier: Apache-2.0
// Simulated cameras through the whole chain: driver, library, sensor, hub and subscriber. The
// cameras are unplugged and plugged in again; the room keeps their entries.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "roomcast/client/subscriber.h"
#include "roomcast/core/temporary_folder.h"
#include "roomcast/hub/server/running_hub.h"
#include "roomcast/sensor/sensor_feed.h"
#include "roomcast/sensor/source_factory.h"
#include "roomcast/source/drivers/freenect/fakenect_fixture.h"
#include "roomcast/source/drivers/freenect/kinect_depth.h"

/// LeakSanitizer asks this. OpenNI does not free everything, and unloads the drivers that could
/// tell whose memory it was.
extern "C" int __lsan_is_turned_off();
extern "C" int __lsan_is_turned_off() {
  return 1;
}

namespace roomcast::tests {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class CameraInARoom : public testing::Test {
 protected:
  CameraInARoom() {
    ::setenv("FAKENECT_PATH", folder_.path().c_str(), 1);
    ::setenv("ROOMCAST_VIRTUAL_CAMERAS", folder_.path().c_str(), 1);
  }
  void unplug() { std::ofstream(folder_ / "unplugged"); }
  void plug_in() { fs::remove(folder_ / "unplugged"); }

  void stream(const std::string& spec) {
    auto source = sensor::open_source(spec);
    ASSERT_TRUE(source.ok()) << source.error().message;
    sensor::SensorFeedOptions options;
    options.hub_url = hub_.url();
    options.codec.depth_mode = codec::DepthMode::kLossless;
    auto feed = sensor::SensorFeed::start(*std::move(source), options);
    ASSERT_TRUE(feed.ok()) << feed.error().message;
    feed_ = *std::move(feed);
    auto viewer =
        client::Subscriber::open({.hub_url = hub_.url(), .room = {}, .name = "test", .log = {}});
    ASSERT_TRUE(viewer.ok()) << viewer.error().message;
    viewer_ = *std::move(viewer);
  }

  /// The first snapshot with decoded pictures after `sets` frame sets.
  std::shared_ptr<const client::RoomSnapshot> room_after(std::uint64_t sets) {
    const auto give_up = std::chrono::steady_clock::now() + 20s;
    auto room = viewer_->snapshot();
    while (room->sets_received < sets || room->sensors.empty() || !room->sensors[0].picture) {
      if (std::chrono::steady_clock::now() > give_up) {
        ADD_FAILURE() << "no picture; " << room->problem;
        break;
      }
      room = viewer_->wait_newer(room->revision, 20ms);
    }
    return room;
  }

  void goes_on_after_it_was_unplugged() {
    const auto before = room_after(1);
    unplug();
    while (feed_->stats().source.is_connected) std::this_thread::yield();
    plug_in();
    while (!feed_->stats().source.is_connected) std::this_thread::yield();
    const auto after = room_after(viewer_->snapshot()->sets_received + 3);
    ASSERT_EQ(after->sensors.size(), 1U);
    EXPECT_EQ(after->sensors[0].id, before->sensors[0].id);
    EXPECT_EQ(feed_->stats().source.disconnect_count, 1U);
    EXPECT_FALSE(feed_->result());
  }

  const TemporaryFolder folder_;
  const hub::RunningHub hub_;
  std::unique_ptr<sensor::SensorFeed> feed_;
  std::unique_ptr<client::Subscriber> viewer_;
};

const DepthImage& depth_in(const client::RoomSnapshot& room) {
  return room.sensors[0].picture->frame.depth_mm;
}

TEST_F(CameraInARoom, a_replayed_kinect_is_seen_as_it_was_recorded) {
  source::write_fakenect_recording(folder_.path(), 60);
  stream("freenect:0");
  const auto room = room_after(2);
  EXPECT_EQ(room->sensors[0].name, "freenect-A00367813501053A");
  const auto mm = source::kinect_mm_from_raw({});
  EXPECT_EQ(depth_in(*room).at(320, 240), mm[source::recorded_raw(320, 240)]);
  EXPECT_EQ(depth_in(*room).at(10, 240), 0);
}

TEST_F(CameraInARoom, a_replayed_kinect_goes_on_after_it_was_unplugged) {
  source::write_fakenect_recording(folder_.path(), 120);
  stream("freenect:A00367813501053A");
  goes_on_after_it_was_unplugged();
}

TEST_F(CameraInARoom, a_virtual_openni_camera_is_seen_as_its_driver_draws_it) {
  stream("openni2:");
  const auto room = room_after(2);
  EXPECT_EQ(room->sensors[0].name, "openni2-VIRTUAL-7");
  EXPECT_EQ(depth_in(*room).at(100, 50), 1200);
}

TEST_F(CameraInARoom, a_virtual_openni_camera_goes_on_after_it_was_unplugged) {
  stream("openni2:VIRTUAL-7");
  goes_on_after_it_was_unplugged();
}

TEST_F(CameraInARoom, several_cameras_work_side_by_side_in_one_process) {
  source::write_fakenect_recording(folder_.path(), 30);
  auto kinect = sensor::open_source("freenect:0"), xtion = sensor::open_source("openni2:");
  ASSERT_TRUE(kinect.ok() && xtion.ok());
  source::CapturedFrame frame;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(*(*kinect)->next(frame, {}));
    EXPECT_EQ(frame.depth_mm.width(), 640);
    ASSERT_TRUE(*(*xtion)->next(frame, {}));
    EXPECT_EQ(frame.depth_mm.width(), 320);
  }
}

TEST_F(CameraInARoom, a_recording_of_a_real_kinect_plays_round_and_round) {
  const char* const data = std::getenv("ROOMCAST_DATA");
  const fs::path file = fs::path(data != nullptr ? data : ROOMCAST_SOURCE_DIR "/../shared/data") /
                        "kinect1_oni_fixed/test.oni";
  if (!fs::exists(file))
    GTEST_SKIP() << "no recording at " << file << "; set ROOMCAST_DATA to test with it";
  stream("openni2:" + file.string());
  const auto room = room_after(16);  // the recording has 12 frames
  EXPECT_EQ(depth_in(*room).width(), 640);
  EXPECT_EQ(feed_->stats().source.disconnect_count, 0U);
}

}  // namespace
}  // namespace roomcast::tests
