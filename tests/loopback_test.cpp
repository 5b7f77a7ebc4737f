// SPDX-License-Identifier: Apache-2.0
// Hub, publishers and subscriber over real loopback sockets, in one process: the subscriber
// receives what was published.
#include <thread>

#include <gtest/gtest.h>

#include "roomcast/client/publisher.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/hub/server/running_hub.h"

namespace roomcast::tests {
namespace {

using namespace std::chrono_literals;

using hub::RunningHub;

constexpr int kWidth = 64, kHeight = 48;

hub::HubOptions on_two_threads() {
  hub::HubOptions options;
  options.threads = 2;
  return options;
}

DepthImage depth_picture(std::uint16_t number) {
  DepthImage depth(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x)
      depth.at(x, y) = static_cast<std::uint16_t>(500 + number + x * y);
  }
  return depth;
}

/// A sensor of 20 frames a second whose Nth frame shows picture number N.
class TestSensor {
 public:
  TestSensor(const std::string& hub_url, const std::string& name) {
    client::PublisherOptions options;
    options.hub_url = hub_url;
    options.name = name;
    options.calibration.depth = {
        .width = kWidth, .height = kHeight, .fx = 60, .fy = 60, .cx = 32, .cy = 24};
    options.calibration.color = options.calibration.depth;
    options.calibration.color_is_registered = true;
    options.fps = 20;
    auto opened = client::Publisher::open(options);
    EXPECT_TRUE(opened.ok()) << opened.error().message;
    publisher = std::move(*opened);
    codec::FrameEncoderOptions encoding;
    encoding.width = kWidth;
    encoding.height = kHeight;
    encoding.depth_mode = codec::DepthMode::kLossless;
    encoder_ = std::move(*codec::FrameEncoder::create(encoding));
  }

  /// Publishes one frame if it is due; else returns false.
  bool send(const DepthImage& depth, const ColorImage& color = {}) {
    const auto turn = publisher->next_turn();
    if (!turn) return false;
    auto message = client::Publisher::begin_frame();
    const MaskImage seen(color.width(), color.height(), 255);
    const auto info = encoder_->encode(depth, color, seen, turn->want_key, message.appendable());
    EXPECT_TRUE(info.ok());
    return publisher->publish(*turn, *info, SteadyClock().now(), std::move(message)).has_value();
  }

  std::unique_ptr<client::Publisher> publisher;

 private:
  std::unique_ptr<codec::FrameEncoder> encoder_;
};

std::unique_ptr<client::Subscriber> watch(const std::string& hub_url) {
  auto subscriber =
      client::Subscriber::open({.hub_url = hub_url, .room = {}, .name = "test", .log = {}});
  EXPECT_TRUE(subscriber.ok()) << subscriber.error().message;
  return std::move(*subscriber);
}

/// Waits for the first room that satisfies `wanted`. Until then `send` lets the sensors send at
/// their pace.
template <class Wanted, class Send>
std::shared_ptr<const client::RoomSnapshot> wait_for(const client::Subscriber& viewer, Send send,
                                                     Wanted wanted) {
  const auto give_up = std::chrono::steady_clock::now() + 10s;
  auto room = viewer.snapshot();
  while (!wanted(*room)) {
    if (std::chrono::steady_clock::now() > give_up) {
      ADD_FAILURE() << "the room never became as wanted; " << room->problem;
      break;
    }
    send();
    room = viewer.wait_newer(room->revision, 20ms);
  }
  return room;
}

std::size_t pictures(const client::RoomSnapshot& room) {
  std::size_t count = 0;
  for (const auto& sensor : room.sensors) count += sensor.picture != nullptr;
  return count;
}

TEST(Loopback, depth_arrives_bit_for_bit_from_every_sensor) {
  const RunningHub hub(on_two_threads());
  TestSensor left(hub.url(), "left"), right(hub.url(), "right");
  const auto viewer = watch(hub.url());
  const auto room = wait_for(
      *viewer, [&] { left.send(depth_picture(1)), right.send(depth_picture(2)); },
      [](const auto& r) { return pictures(r) == 2; });
  ASSERT_EQ(room->sensors.size(), 2u);
  EXPECT_EQ(room->sensors[0].name, "left");
  EXPECT_EQ(room->sensors[0].picture->frame.depth_mm, depth_picture(1));
  EXPECT_EQ(room->sensors[1].picture->frame.depth_mm, depth_picture(2));
}

TEST(Loopback, a_late_viewer_is_given_a_key_frame) {
  const RunningHub hub(on_two_threads());
  TestSensor sensor(hub.url(), "left");
  const ColorImage color(kWidth, kHeight, Rgb8{200, 100, 50});
  const auto early = watch(hub.url());
  const auto send = [&] { sensor.send(depth_picture(1), color); };
  wait_for(*early, send, [](const auto& r) { return r.sets_received > 5; });
  const auto late = watch(hub.url());
  const auto room = wait_for(*late, send, [](const auto& r) { return pictures(r) == 1; });
  EXPECT_NEAR(room->sensors[0].picture->frame.color.at(kWidth / 2, kHeight / 2).r, 200, 12);
}

TEST(Loopback, a_sensor_that_comes_back_keeps_its_id) {
  const RunningHub hub(on_two_threads());
  const auto viewer = watch(hub.url());
  auto left = std::make_unique<TestSensor>(hub.url(), "left");
  TestSensor right(hub.url(), "right");
  wait_for(
      *viewer, [&] { left->send(depth_picture(1)), right.send(depth_picture(2)); },
      [](const auto& r) { return pictures(r) == 2; });
  left.reset();
  wait_for(
      *viewer, [&] { right.send(depth_picture(2)); },
      [](const auto& r) { return !r.sensors[0].online; });
  left = std::make_unique<TestSensor>(hub.url(), "left");
  const auto room = wait_for(
      *viewer, [&] { left->send(depth_picture(3)), right.send(depth_picture(2)); },
      [](const auto& r) {
        return r.sensors[0].online && r.sensors[0].picture->frame.depth_mm == depth_picture(3);
      });
  EXPECT_EQ(room->sensors.size(), 2u);
  EXPECT_EQ(room->sensors[0].id, SensorId{0});
}

TEST(Loopback, everyone_comes_back_when_the_hub_does) {
  auto hub = std::make_unique<RunningHub>(on_two_threads());
  const std::uint16_t port = hub->port();
  TestSensor sensor(hub->url(), "left");
  const auto viewer = watch(hub->url());
  const auto send = [&] { sensor.send(depth_picture(1)); };
  wait_for(*viewer, send, [](const auto& r) { return pictures(r) == 1; });
  hub.reset();
  const auto alone = wait_for(*viewer, send, [](const auto& r) { return !r.connected; });
  EXPECT_FALSE(alone->problem.empty());
  hub = std::make_unique<RunningHub>(on_two_threads(), port);
  const auto sets_before = viewer->snapshot()->sets_received;
  wait_for(*viewer, send,
           [&](const auto& r) { return r.connected && r.sets_received > sets_before; });
}

TEST(Loopback, two_sensors_of_one_name_do_not_fight) {
  const RunningHub hub(on_two_threads());
  TestSensor first(hub.url(), "left");
  const TestSensor second(hub.url(), "left");
  const auto give_up = std::chrono::steady_clock::now() + 5s;
  while (!first.publisher->failure() && std::chrono::steady_clock::now() < give_up)
    std::this_thread::yield();
  ASSERT_TRUE(first.publisher->failure().has_value());
  EXPECT_NE(first.publisher->failure()->message.find("joined again"), std::string::npos);
  EXPECT_FALSE(second.publisher->failure().has_value());
}

TEST(Loopback, without_a_hub_open_fails_with_a_sentence) {
  const std::string url = RunningHub().url();  // the hub has stopped by now
  const auto subscriber =
      client::Subscriber::open({.hub_url = url, .room = {}, .name = {}, .log = {}});
  ASSERT_FALSE(subscriber.ok());
  EXPECT_EQ(subscriber.error().code, ErrorCode::kUnavailable);
  const auto elsewhere =
      client::Subscriber::open({.hub_url = "gopher://x", .room = {}, .name = {}, .log = {}});
  ASSERT_FALSE(elsewhere.ok());
  EXPECT_EQ(elsewhere.error().code, ErrorCode::kInvalidArgument);
}

TEST(Loopback, another_rooms_name_is_refused_for_good) {
  const RunningHub hub(on_two_threads());
  const auto subscriber =
      client::Subscriber::open({.hub_url = hub.url(), .room = "kitchen", .name = {}, .log = {}});
  ASSERT_FALSE(subscriber.ok());
  EXPECT_NE(subscriber.error().message.find("no such room"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::tests
