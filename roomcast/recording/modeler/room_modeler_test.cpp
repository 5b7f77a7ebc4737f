// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/modeler/room_modeler.h"

#include <functional>
#include <optional>
#include <thread>

#include <gtest/gtest.h>

#include "roomcast/client/publisher.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/core/temporary_folder.h"
#include "roomcast/hub/server/running_hub.h"
#include "roomcast/model/pieces/model_message.h"
#include "roomcast/recording/export/wall_fixture.h"

namespace roomcast::recording {
namespace {

using namespace std::chrono_literals;

/// A sensor before a wall that sends key frames, one after the other, while they are wanted.
class WallSensor {
 public:
  explicit WallSensor(const hub::RunningHub& hub) {
    const SetSensor sensor = wall_sensors()[0];
    client::PublisherOptions options;
    options.hub_url = hub.url();
    options.name = sensor.name;
    options.calibration = {sensor.depth, sensor.depth, {}, true};
    options.world_from_depth = wall_pose(0);
    publisher_ = *client::Publisher::open(std::move(options));
    codec::FrameEncoderOptions coding{.width = 64, .height = 48};
    coding.depth_mode = codec::DepthMode::kLossless;
    encoder_ = *codec::FrameEncoder::create(coding);
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }

  [[nodiscard]] std::uint64_t frames_sent() const { return publisher_->stats().frames_sent; }
  [[nodiscard]] bool is_wanted() const { return publisher_->frames_wanted(); }

 private:
  void run(const std::stop_token& stop) {
    const FrameSet wall = wall_set();
    const codec::DecodedFrame& seen = *wall.frames[0].pictures;
    while (!stop.stop_requested()) {
      std::this_thread::sleep_for(20ms);
      const auto turn = publisher_->frames_wanted() ? publisher_->next_turn() : std::nullopt;
      if (!turn) continue;
      auto message = client::Publisher::begin_frame();
      const auto info =
          encoder_->encode(seen.depth_mm, seen.color, seen.color_seen, true, message.appendable());
      ASSERT_TRUE(info.ok());
      publisher_->publish(*turn, *info, SteadyClock().now(), std::move(message));
    }
  }

  std::unique_ptr<client::Publisher> publisher_;
  std::unique_ptr<codec::FrameEncoder> encoder_;
  std::jthread thread_;
};

class RoomModelerTest : public testing::Test {
 protected:
  void start() {
    modeler = std::make_unique<RoomModeler>(RoomModelerOptions{.hub_url = hub.url(),
                                                               .room = "room",
                                                               .token = hub.server().own_token(),
                                                               .folder = folder / "room"});
  }
  std::unique_ptr<client::Subscriber> watch() {
    return *client::Subscriber::open({.hub_url = hub.url(), .room = {}, .name = {}, .log = {}});
  }
  static bool within_20_s(const std::function<bool()>& done) {
    const auto give_up = std::chrono::steady_clock::now() + 20s;
    while (!done() && std::chrono::steady_clock::now() < give_up) std::this_thread::sleep_for(5ms);
    return done();
  }

  TemporaryFolder folder;
  const hub::RunningHub hub;
  std::unique_ptr<RoomModeler> modeler;
};

TEST_F(RoomModelerTest, fuses_what_a_watched_room_shows_and_keeps_it_across_a_restart) {
  start();
  std::optional<WallSensor> sensor(hub);
  auto viewer = watch();
  ASSERT_TRUE(within_20_s([&] { return modeler->changes_after(0) != nullptr; }));
  const auto model = modeler->changes_after(0);
  const auto message = model::read_model_message(
      std::span(reinterpret_cast<const std::uint8_t*>(model->data()), model->size()));
  ASSERT_TRUE(message.ok());
  EXPECT_TRUE(message->is_whole);
  EXPECT_FALSE(message->pieces.empty());
  EXPECT_EQ(modeler->changes_after(message->version), nullptr);
  EXPECT_EQ(viewer->snapshot()->people.size(), 1u) << "a modeler is nobody in the room";

  modeler.reset();
  viewer.reset();
  sensor.reset();
  start();
  ASSERT_TRUE(within_20_s([&] { return modeler->changes_after(0) != nullptr; }))
      << "without any sensor";
}

TEST_F(RoomModelerTest, no_sensor_sends_for_it) {
  start();
  const WallSensor sensor(hub);
  ASSERT_TRUE(within_20_s([&] { return !sensor.is_wanted(); }));
  const std::uint64_t sent = sensor.frames_sent();
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ(sensor.frames_sent(), sent);
  EXPECT_EQ(modeler->changes_after(0), nullptr);
}

TEST_F(RoomModelerTest, ends_at_once_without_a_hub) {
  RoomModeler alone({.hub_url = "ws://127.0.0.1:1", .room = "room", .token = "none"});
  EXPECT_EQ(alone.changes_after(0), nullptr);
}

}  // namespace
}  // namespace roomcast::recording
