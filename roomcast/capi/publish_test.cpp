// SPDX-License-Identifier: Apache-2.0
// A program that is a sensor, and one that watches it, through the C functions and a real hub.
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <future>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <boost/asio/post.hpp>
#include <gtest/gtest.h>

#include "roomcast/capi/room_fixture.h"
#include "roomcast/capi/roomcast.h"
#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/hub/server/running_hub.h"

namespace roomcast::capi {
namespace {

using namespace std::chrono_literals;

constexpr int kDepthWidth = 80, kDepthHeight = 60, kColorWidth = 160, kColorHeight = 120;

/// A sensor as a C program describes it; lossless depth, with a colour camera of its own.
struct Described {
  Described() {
    sensor.size = sizeof(sensor);
    sensor.depth = &depth;
    sensor.color = &color;
    sensor.world_from_depth = pose.data();
    sensor.depth_mode = ROOMCAST_DEPTH_LOSSLESS;
    sensor.send_unwatched = 1;
  }
  roomcast_camera depth{sizeof(depth), kDepthWidth, kDepthHeight, 70, 70, 40, 30, 0.01, 0, 0, 0, 0};
  roomcast_camera color{sizeof(color), kColorWidth, kColorHeight, 140, 140, 80, 60, 0, 0, 0, 0, 0};
  std::array<double, 16> pose{1, 0, 0, 0.5, 0, -1, 0, 2, 0, 0, -1, 3, 0, 0, 0, 1};
  roomcast_sensor_options sensor{};
};

/// Noise: no reading of it is what a lossy codec would make of its neighbours.
std::vector<std::uint16_t> noise(unsigned seed, std::size_t pixels = kDepthWidth * kDepthHeight) {
  std::mt19937 random(seed);
  std::vector<std::uint16_t> depth(pixels);
  std::ranges::generate(depth, [&] { return static_cast<std::uint16_t>(random()); });
  return depth;
}

roomcast_capture capture_of(const std::vector<std::uint16_t>& depth,
                            const std::vector<std::uint8_t>& color) {
  return {sizeof(roomcast_capture),
          roomcast_host_time_ns(),
          depth.data(),
          kDepthWidth,
          kDepthHeight,
          color.empty() ? nullptr : color.data(),
          kColorWidth,
          kColorHeight};
}

Publisher publish(const std::string& hub, const Described& described, const char* name = "left") {
  char error[300] = "";
  const roomcast_options options = joining(hub, name);
  Publisher publisher(roomcast_publish(&options, &described.sensor, error, sizeof(error)));
  EXPECT_NE(publisher, nullptr) << error;
  return publisher;
}

roomcast_send_report send(const Publisher& publisher, const roomcast_capture& capture) {
  char error[300] = "";
  roomcast_send_report report{};
  report.size = sizeof(report);
  EXPECT_EQ(roomcast_send_frame(publisher.get(), &capture, &report, error, sizeof(error)), 1)
      << error;
  return report;
}

TEST(PublishingSensor, frames_that_nobody_would_watch_are_skipped_and_not_counted) {
  const hub::RunningHub hub;
  Described described;
  described.sensor.send_unwatched = 0;
  const Publisher publisher = publish(hub.url(), described);
  const auto depth = noise(1);
  const auto is_connected = [&] { return send(publisher, capture_of(depth, {})).connected == 1; };
  ASSERT_TRUE(until(is_connected));
  roomcast_send_report skipped{};
  ASSERT_TRUE(until([&] { return (skipped = send(publisher, capture_of(depth, {}))).sent == 0; }));
  std::this_thread::sleep_for(300ms);  // room time is known by now
  const auto later = send(publisher, capture_of(depth, {}));
  EXPECT_EQ(later.sent, 0);
  EXPECT_EQ(later.frames_skipped, skipped.frames_skipped);

  const std::string url = hub.url();
  const roomcast_options options = joining(url, "viewer");
  char error[300] = "";
  const Viewer viewer(roomcast_connect(&options, error, sizeof(error)));
  ASSERT_NE(viewer, nullptr) << error;
  EXPECT_TRUE(until([&] { return send(publisher, capture_of(depth, {})).sent == 1; }));
}

TEST(PublishingSensor, its_depth_arrives_bit_for_bit_with_colour_pose_and_time) {
  const hub::RunningHub hub;
  const Described described;
  const Publisher publisher = publish(hub.url(), described);
  const std::string url = hub.url();
  const roomcast_options options = joining(url, "watcher");
  const Viewer viewer(roomcast_connect(&options, nullptr, 0));
  ASSERT_NE(viewer, nullptr);
  const auto depth = noise(1);
  std::vector<std::uint8_t> color(kColorWidth * kColorHeight * 3, 128);
  for (std::size_t i = 0; i < color.size(); i += 3) color[i] = 200;
  roomcast_sensor seen{};
  roomcast_send_report sent{};
  Frames frames;
  ASSERT_TRUE(until([&] {
    const auto report = send(publisher, capture_of(depth, color));
    if (report.sent == 1) sent = report;
    frames.reset(roomcast_wait_frames(viewer.get(), 20));
    seen.size = sizeof(seen);
    return frames && roomcast_get_sensor(frames.get(), 0, &seen) == 1;
  }));
  EXPECT_STREQ(seen.name, "left");
  ASSERT_EQ(std::pair(seen.width, seen.height), std::pair(kDepthWidth, kDepthHeight));
  EXPECT_TRUE(std::equal(depth.begin(), depth.end(), seen.depth_mm));
  EXPECT_EQ(seen.fx, 70);
  EXPECT_EQ(seen.k1, 0.01);
  EXPECT_EQ(seen.placed, 1);
  EXPECT_TRUE(std::equal(described.pose.begin(), described.pose.end(), seen.world_from_depth));
  EXPECT_LE(seen.seq, sent.seq);
  EXPECT_LT(std::abs(seen.capture_ns - roomcast_host_time_ns()), 10'000'000'000);
  const nanoseconds now = std::chrono::system_clock::now().time_since_epoch();
  EXPECT_LT(std::abs(now.count() - seen.capture_utc_ns), 10'000'000'000);
  ASSERT_NE(seen.color_rgb, nullptr);
  std::size_t red = 0, valid = 0;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (seen.color_seen[i] == 0) continue;
    ++valid;
    red += std::abs(seen.color_rgb[3 * i] - 200) < 25 ? 1 : 0;
  }
  EXPECT_GT(valid, 0u);
  EXPECT_GT(red, valid / 2);
}

TEST(PublishingSensor, a_report_counts_and_numbers_what_was_sent) {
  const hub::RunningHub hub;
  const Publisher publisher = publish(hub.url(), Described());
  const auto depth = noise(2);
  roomcast_send_report report{};
  ASSERT_TRUE(until([&] { return (report = send(publisher, capture_of(depth, {}))).sent == 1; }));
  EXPECT_EQ(report.connected, 1);
  EXPECT_EQ(report.max_frames_waiting, 2u);
  EXPECT_EQ(report.rate_share, 1);
  EXPECT_LT(std::abs(report.capture_ns - roomcast_host_time_ns()), 10'000'000'000);
  const std::uint64_t skipped = report.frames_skipped;
  ASSERT_TRUE(until([&] { return send(publisher, capture_of(depth, {})).frames_sent >= 3; }));
  report = send(publisher, capture_of(depth, {}));
  EXPECT_GT(report.bytes_sent, 3 * depth.size());
  EXPECT_GE(report.frames_skipped, skipped);
}

TEST(PublishingSensor, a_program_of_an_earlier_header_gets_the_part_of_the_report_that_it_knows) {
  const hub::RunningHub hub;
  const Publisher publisher = publish(hub.url(), Described());
  const auto depth = noise(3);
  const auto capture = capture_of(depth, {});
  roomcast_send_report report{};
  report.size = offsetof(roomcast_send_report, frames_waiting);
  report.max_frames_waiting = 12345;
  EXPECT_EQ(roomcast_send_frame(publisher.get(), &capture, &report, nullptr, 0), 1);
  EXPECT_EQ(report.connected, 1);
  EXPECT_EQ(report.max_frames_waiting, 12345u);
  EXPECT_EQ(roomcast_send_frame(publisher.get(), &capture, nullptr, nullptr, 0), 1);
}

TEST(PublishingSensor, while_a_hub_does_not_read_frames_are_skipped_and_the_program_is_told) {
  client::NetworkThread network;
  std::optional<client::FakeHub> hub(std::in_place, network.io());
  network.start();
  Described described;
  described.depth.width = 640, described.depth.height = 480;
  described.sensor.color = nullptr;
  Publisher publisher = publish(hub->url(), described);
  const auto depth = noise(4, 640 * 480);
  auto capture = capture_of(depth, {});
  capture.depth_width = 640, capture.depth_height = 480;
  const auto send_now = [&] {
    capture.capture_ns = 0;
    return send(publisher, capture);
  };
  ASSERT_TRUE(until([&] { return send_now().sent == 1; }));
  std::promise<void> go_on;
  boost::asio::post(network.io(), [future = go_on.get_future().share()] { future.wait(); });
  roomcast_send_report report{};
  ASSERT_TRUE(until([&] {  // 614 kB a frame fill the sockets
    report = send_now();
    return report.sent == 0 && report.frames_waiting == report.max_frames_waiting;
  }));
  EXPECT_EQ(report.connected, 1);
  const auto next = send_now();
  EXPECT_EQ(next.sent, 0);
  EXPECT_EQ(next.frames_skipped, report.frames_skipped + 1);
  EXPECT_EQ(roomcast_is_publishing(publisher.get(), nullptr, 0), 1);
  go_on.set_value();
  ASSERT_TRUE(until([&] { return (report = send_now()).sent == 1; }));
  EXPECT_LT(report.rate_share, 1) << "colour should take less from now on";
  publisher.reset();
  network.finish([&] { hub.reset(); });
}

TEST(PublishingSensor, several_threads_may_send_and_ask_at_the_same_time) {
  const hub::RunningHub hub;
  const Publisher publisher = publish(hub.url(), Described());
  const auto depth = noise(9);
  ASSERT_TRUE(until([&] { return send(publisher, capture_of(depth, {})).sent == 1; }));
  const auto before = send(publisher, capture_of(depth, {}));
  std::vector<std::jthread> threads;
  std::atomic<std::uint64_t> skipped = 0;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&] {
      for (int frame = 0; frame < 50; ++frame) {
        skipped += send(publisher, capture_of(depth, {})).sent == 1 ? 0 : 1;
        EXPECT_EQ(roomcast_is_publishing(publisher.get(), nullptr, 0), 1);
      }
    });
  }
  threads.clear();
  const auto after = send(publisher, capture_of(depth, {}));
  EXPECT_EQ(after.frames_skipped, before.frames_skipped + skipped + (after.sent == 1 ? 0 : 1));
}

TEST(PublishingSensor, a_hub_that_goes_is_told_and_found_again) {
  std::optional<hub::RunningHub> hub(std::in_place);
  const std::uint16_t port = hub->port();
  const Publisher publisher = publish(hub->url(), Described());
  const auto depth = noise(5);
  EXPECT_EQ(roomcast_is_publishing(publisher.get(), nullptr, 0), 1);
  hub.reset();
  char error[300] = "";
  ASSERT_TRUE(
      until([&] { return roomcast_is_publishing(publisher.get(), error, sizeof(error)) == 0; }));
  EXPECT_NE(std::string(error), "");
  const auto report = send(publisher, capture_of(depth, {}));
  EXPECT_EQ(report.sent, 0);
  EXPECT_EQ(report.connected, 0);
  EXPECT_GT(report.frames_skipped, 0u);
  hub.emplace(hub::HubOptions{}, port);
  EXPECT_TRUE(until([&] { return send(publisher, capture_of(depth, {})).sent == 1; }));
}

TEST(PublishingSensor, one_that_stops_can_come_back_under_its_name) {
  const hub::RunningHub hub;
  const auto depth = noise(6);
  for (int time = 0; time < 2; ++time) {
    Publisher publisher = publish(hub.url(), Described());
    EXPECT_TRUE(until([&] { return send(publisher, capture_of(depth, {})).sent == 1; }));
    roomcast_stop_publishing(publisher.release());
  }
  roomcast_stop_publishing(nullptr);
}

TEST(PublishingSensor, a_bad_frame_is_refused_and_the_next_one_is_sent) {
  const hub::RunningHub hub;
  const Publisher publisher = publish(hub.url(), Described());
  const auto depth = noise(7);
  auto capture = capture_of(depth, {});
  capture.depth_width = kDepthWidth + 1;
  char error[300] = "";
  roomcast_send_report report{};
  report.size = sizeof(report);
  report.sent = 7;
  EXPECT_EQ(roomcast_send_frame(publisher.get(), &capture, &report, error, sizeof(error)), 0);
  EXPECT_EQ(report.sent, 0);
  EXPECT_NE(std::string(error).find("81 x 60"), std::string::npos) << error;
  EXPECT_EQ(roomcast_send_frame(publisher.get(), nullptr, &report, nullptr, 0), 0);
  EXPECT_TRUE(until([&] { return send(publisher, capture_of(depth, {})).sent == 1; }));
}

TEST(PublishingSensor, a_frame_larger_than_a_hub_takes_is_told) {
  const hub::RunningHub hub;
  Described described;
  described.depth.width = 1280, described.depth.height = 1024;
  described.sensor.color = nullptr;
  const Publisher publisher = publish(hub.url(), described);
  const auto depth = noise(8, 1280 * 1024);
  auto capture = capture_of(depth, {});
  capture.depth_width = 1280, capture.depth_height = 1024;
  char error[300] = "";
  ASSERT_TRUE(until([&] {
    capture.capture_ns = 0;
    return roomcast_send_frame(publisher.get(), &capture, nullptr, error, sizeof(error)) == 0;
  }));
  EXPECT_NE(std::string(error).find("more than a hub takes"), std::string::npos) << error;
  EXPECT_EQ(roomcast_is_publishing(publisher.get(), nullptr, 0), 1);
}

TEST(PublishingSensor, what_no_sensor_can_be_is_refused_with_a_sentence) {
  const hub::RunningHub hub;
  const auto refused = [&](auto spoil) {
    Described described;
    roomcast_options options = joining("", "left");
    const std::string url = hub.url();
    options.hub = url.c_str();
    spoil(described, options);
    char error[300] = "";
    const Publisher publisher(roomcast_publish(&options, &described.sensor, error, sizeof(error)));
    EXPECT_EQ(publisher, nullptr);
    return std::string(error);
  };
  const std::string long_name(100'000, 'x');
  for (const std::string& sentence : {
           refused([](auto&d, auto&) { d.depth.width = 8; }),
           refused([](auto&d, auto&) { d.depth.width = 8192; }),
           refused([](auto&d, auto&) { d.color.width = 1; }),
           refused([](auto&d, auto&) { d.sensor.fps = -1; }),
           refused([](auto&d, auto&) { d.sensor.fps = std::nan(""); }),
           refused([](auto&d, auto&) { d.sensor.fps = 241; }),
           refused([](auto&d, auto&) { d.sensor.depth_bound_mm = 64; }),
           refused([](auto&d, auto&) { d.sensor.color_kbit_per_s = 49; }),
           refused([](auto&d, auto&) { d.pose[3] = 1e9; }),
           refused([](auto&, auto&o) { o.name = "\xff"; }),
           refused([&](auto&, auto&o) { o.name = long_name.c_str(); }),
           refused([&](auto&, auto&o) { o.room = long_name.c_str(); }),
           refused([&](auto&, auto&o) { o.token = long_name.c_str(); }),
           refused([&](auto&, auto&o) { o.hub = long_name.c_str(); }),
           refused([](auto&, auto&o) { o.hub = nullptr; }),
           refused([](auto&, auto&o) { o.room = "no such room"; }),
       }) {
    EXPECT_NE(sentence, "");
  }
  EXPECT_EQ(roomcast_publish(nullptr, nullptr, nullptr, 0), nullptr);
}

TEST(PublishingSensor, no_publisher_is_no_crash) {
  const roomcast_capture capture{};
  char error[100] = "";
  EXPECT_EQ(roomcast_send_frame(nullptr, &capture, nullptr, error, sizeof(error)), 0);
  EXPECT_STREQ(error, "publisher is NULL");
  EXPECT_EQ(roomcast_is_publishing(nullptr, error, sizeof(error)), 0);
}

}  // namespace
}  // namespace roomcast::capi
