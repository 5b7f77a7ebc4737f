// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/sender/frame_sender.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <limits>
#include <optional>
#include <random>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/client/uplink/bandwidth_estimator.h"

namespace roomcast::sensor {
namespace {

using namespace std::chrono_literals;

client::PublisherOptions sensor_of(const std::string& hub_url, int width, int height) {
  client::PublisherOptions options;
  options.hub_url = hub_url;
  options.name = "left";
  options.calibration.depth = {
      .width = width, .height = height, .fx = 60, .fy = 60, .cx = 0.5 * width, .cy = 0.5 * height};
  options.calibration.color = options.calibration.depth;
  options.calibration.color_is_registered = true;
  return options;
}

class FrameSenderTest : public testing::Test {
 protected:
  FrameSenderTest() { network.start(); }
  ~FrameSenderTest() override {
    network.finish([this] { hub.reset(); });
  }

  std::unique_ptr<FrameSender> open(int width, int height) {
    auto sender = FrameSender::open(sensor_of(hub->url(), width, height),
                                    {.depth_mode = codec::DepthMode::kLossless});
    EXPECT_TRUE(sender.ok()) << sender.error().message;
    return std::move(*sender);
  }

  /// Sends until the frame is not skipped.
  static Result<std::optional<client::Publisher::Published>> send(FrameSender& sender,
                                                                  DepthView depth,
                                                                  ColorView color = {}) {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    for (;;) {
      auto sent = sender.send(depth, color, SteadyClock().now());
      if (!sent || *sent || std::chrono::steady_clock::now() > give_up) return sent;
      std::this_thread::sleep_for(1ms);
    }
  }

  client::NetworkThread network;
  std::optional<client::FakeHub> hub{std::in_place, network.io()};
};

TEST_F(FrameSenderTest, a_target_rate_needs_live_depth_and_a_sensible_number) {
  const auto exact =
      FrameSender::open(sensor_of(hub->url(), 64, 48),
                        {.depth_mode = codec::DepthMode::kLossless, .target_mbit_per_s = 2});
  ASSERT_FALSE(exact.ok());
  EXPECT_EQ(exact.error().code, ErrorCode::kInvalidArgument);
  for (const double mbit : {-1.0, 0.01, 1e6, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(FrameSender::open(sensor_of(hub->url(), 64, 48), {.target_mbit_per_s = mbit}).ok())
        << mbit;
}

TEST_F(FrameSenderTest, with_a_target_rate_fewer_frames_are_sent_than_would_fit_otherwise) {
  auto options = sensor_of(hub->url(), 320, 240);
  auto sender = FrameSender::open(options, {.target_mbit_per_s = 0.1});
  ASSERT_TRUE(sender.ok()) << sender.error().message;
  std::minstd_rand random(3);
  DepthImage noise(320, 240);
  std::size_t bytes = 0;
  const auto began = SteadyClock().now();
  for (int i = 0; i < 60; ++i) {
    for (std::size_t k = 0; k < noise.view().pixel_count(); ++k)
      noise.data()[k] = static_cast<std::uint16_t>(500 + random() % 4'000);
    (void)(*sender)->send(noise, {}, SteadyClock().now());
    std::this_thread::sleep_for(33ms);
  }
  bytes = (*sender)->publisher().stats().bytes_sent;
  const std::chrono::duration<double> seconds = SteadyClock().now() - began;
  const auto sent = (*sender)->publisher().stats().frames_sent;
  EXPECT_GT(sent, 0u);
  EXPECT_LT(sent, 8u) << bytes << " bytes in " << seconds.count() << " s";
}

TEST_F(FrameSenderTest, the_small_rendition_goes_ahead_of_the_full_one_while_it_is_wanted) {
  auto sender = FrameSender::open(sensor_of(hub->url(), 320, 240), {});
  ASSERT_TRUE(sender.ok()) << sender.error().message;
  const auto tell = [&](bool small) {
    wire::pb::Control demand;
    demand.mutable_frame_demand()->set_wanted(true);
    demand.mutable_frame_demand()->set_small(small);
    boost::asio::post(network.io(), [this, demand] { hub->say(demand); });
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    while ((*sender)->publisher().demand().small != small &&
           std::chrono::steady_clock::now() < give_up)
      std::this_thread::sleep_for(1ms);
  };
  const DepthImage depth(320, 240, 2'000);
  const auto send_some = [&] {
    for (int i = 0; i < 10; ++i) {
      EXPECT_TRUE(send(**sender, depth).ok());
      std::this_thread::sleep_for(40ms);
    }
  };
  send_some();
  tell(true);
  send_some();
  tell(false);
  send_some();
  const auto sent = (*sender)->publisher().stats().frames_sent;
  std::vector<wire::FrameHeader> frames;
  const auto full_frames = [&] {
    return static_cast<std::uint64_t>(std::ranges::count(frames, false, &wire::FrameHeader::small));
  };
  for (int i = 0; i < 500 && full_frames() < sent; ++i) {
    std::promise<std::vector<wire::FrameHeader>> heard;
    boost::asio::post(network.io(), [&] { heard.set_value(hub->frames); });
    frames = heard.get_future().get();
    std::this_thread::sleep_for(10ms);
  }
  const auto is_small = [](const wire::FrameHeader& header) { return header.small; };
  const auto first = std::ranges::find_if(frames, is_small);
  ASSERT_NE(first, frames.end());
  EXPECT_TRUE(first->key);
  EXPECT_EQ(first->seq, 0u) << "it counts its own frames";
  EXPECT_FALSE(frames.front().small);
  EXPECT_FALSE(frames.back().small);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!frames[i].small) continue;
    ASSERT_LT(i + 1, frames.size());
    EXPECT_FALSE(frames[i + 1].small);
    const auto apart = frames[i + 1].capture_time - frames[i].capture_time;
    EXPECT_LT(std::chrono::abs(apart), 5ms) << "the estimate of the hub's clock may have changed";
  }
}

TEST_F(FrameSenderTest, it_keeps_to_the_rooms_rate_while_there_is_one) {
  auto options = sensor_of(hub->url(), 320, 240);
  options.follows_rate = true;
  auto sender = FrameSender::open(options, {});
  ASSERT_TRUE(sender.ok()) << sender.error().message;
  const auto tell = [&](double mbit) {
    wire::pb::Control demand;
    demand.mutable_frame_demand()->set_wanted(true);
    demand.mutable_frame_demand()->set_mbit(mbit);
    boost::asio::post(network.io(), [this, demand] { hub->say(demand); });
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    while ((*sender)->publisher().demand().mbit != mbit &&
           std::chrono::steady_clock::now() < give_up)
      std::this_thread::sleep_for(1ms);
  };
  std::minstd_rand random(3);
  DepthImage noise(320, 240);
  const auto frames_sent_in_2_s = [&] {
    const auto before = (*sender)->publisher().stats().frames_sent;
    for (int i = 0; i < 60; ++i) {
      for (std::size_t k = 0; k < noise.view().pixel_count(); ++k)
        noise.data()[k] = static_cast<std::uint16_t>(500 + random() % 4'000);
      (void)(*sender)->send(noise, {}, SteadyClock().now());
      std::this_thread::sleep_for(33ms);
    }
    return (*sender)->publisher().stats().frames_sent - before;
  };
  tell(0.1);
  EXPECT_LT(frames_sent_in_2_s(), 8u);
  tell(0);
  std::uint64_t most = 0;  // TCP's own estimate of the line needs a while to grow
  for (int i = 0; i < 10 && most <= 20; ++i) most = std::max(most, frames_sent_in_2_s());
  EXPECT_GT(most, 20u) << "without a limit again";
}

TEST_F(FrameSenderTest, what_no_viewer_sees_is_sent_less_until_it_is_seen) {
  auto sender = FrameSender::open(sensor_of(hub->url(), 160, 128), {});
  ASSERT_TRUE(sender.ok()) << sender.error().message;
  const auto look = [&](float forward_z) {
    wire::pb::Control control;
    wire::pb::ViewCone& cone = *control.mutable_watched_from()->add_cones();
    cone.mutable_forward()->set_z(forward_z);
    cone.set_half_angle(0.7F);
    boost::asio::post(network.io(), [this, control] { hub->say(control); });
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    const auto is_told = [&] {
      const auto views = (*sender)->publisher().views();
      return views && views->cones(0).forward().z() == forward_z;
    };
    while (!is_told() && std::chrono::steady_clock::now() < give_up)
      std::this_thread::sleep_for(1ms);
    EXPECT_TRUE(is_told());
  };
  // A thing that comes and goes before a wall.
  DepthImage pictures[2] = {DepthImage(160, 128, 3000), DepthImage(160, 128, 3000)};
  for (int y = 30; y < 100; ++y) {
    for (int x = 40; x < 120; ++x) pictures[1].at(x, y) = 1500;
  }
  int frame = 0;
  const auto thing_is_sent = [&](int frames) {
    int changes = 0;
    for (int i = 0; i < frames; ++i) {
      const DepthImage& picture = pictures[++frame / 4 % 2];
      EXPECT_TRUE(*send(**sender, picture));
      changes += (*sender)->decoded_depth().at(80, 64) / 1000 == picture.at(80, 64) / 1000;
    }
    return changes;
  };
  thing_is_sent(2);
  look(1);
  EXPECT_GE(thing_is_sent(40), 36);
  look(-1);
  EXPECT_LE(thing_is_sent(40), 34);
  look(1);
  EXPECT_GE(thing_is_sent(40), 36);
}

TEST_F(FrameSenderTest, a_stream_that_fits_its_line_learns_what_loopback_carries) {
  auto sender = FrameSender::open(sensor_of(hub->url(), 320, 240), {.fits_line = true});
  ASSERT_TRUE(sender.ok()) << sender.error().message;
  EXPECT_EQ((*sender)->publisher().uplink()->bytes_per_s, client::BandwidthEstimator::kStart);
  std::minstd_rand random(3);
  DepthImage noise(320, 240);
  const auto give_up = std::chrono::steady_clock::now() + 20s;
  while ((*sender)->publisher().uplink()->bytes_per_s < 3 * client::BandwidthEstimator::kStart &&
         std::chrono::steady_clock::now() < give_up) {
    for (std::size_t k = 0; k < noise.view().pixel_count(); ++k)
      noise.data()[k] = static_cast<std::uint16_t>(500 + random() % 4'000);
    ASSERT_TRUE((*sender)->send(noise, {}, SteadyClock().now()).ok());
    std::this_thread::sleep_for(20ms);
  }
  EXPECT_GE((*sender)->publisher().uplink()->bytes_per_s, 3 * client::BandwidthEstimator::kStart);
}

TEST_F(FrameSenderTest, what_fits_the_line_needs_live_depth_and_no_number) {
  const auto options = sensor_of(hub->url(), 64, 48);
  EXPECT_FALSE(FrameSender::open(options, {.target_mbit_per_s = 2, .fits_line = true}).ok());
  EXPECT_FALSE(
      FrameSender::open(options, {.depth_mode = codec::DepthMode::kLossless, .fits_line = true})
          .ok());
}

TEST_F(FrameSenderTest, a_frame_is_registered_encoded_and_published) {
  const auto sender = open(64, 48);
  const auto sent = send(*sender, DepthImage(64, 48, 1500), ColorImage(64, 48, Rgb8{9, 8, 7}));
  ASSERT_TRUE(sent.ok()) << sent.error().message;
  ASSERT_TRUE(sent->has_value());
  EXPECT_EQ(sender->registered().color.at(10, 10), (Rgb8{9, 8, 7}));
  EXPECT_EQ(sender->registered().seen.at(10, 10), 255);
}

TEST_F(FrameSenderTest, a_frame_without_colour_does_not_repeat_the_last_colour) {
  const auto sender = open(64, 48);
  ASSERT_TRUE(send(*sender, DepthImage(64, 48, 1500), ColorImage(64, 48)).ok());
  ASSERT_TRUE(send(*sender, DepthImage(64, 48, 1500)).ok());
  EXPECT_TRUE(sender->registered().color.empty());
}

TEST_F(FrameSenderTest, pictures_of_another_size_are_refused) {
  const auto sender = open(64, 48);
  EXPECT_FALSE(send(*sender, DepthImage(48, 64, 1500)).ok());
  EXPECT_FALSE(send(*sender, DepthImage(64, 48, 1500), ColorImage(48, 64)).ok());
}

TEST_F(FrameSenderTest, a_frame_above_the_limit_of_the_wire_is_reported_and_the_next_one_is_sent) {
  const auto sender = open(1280, 1024);
  std::mt19937 random(1);
  DepthImage noise(1280, 1024);
  for (int y = 0; y < noise.height(); ++y) {
    for (int x = 0; x < noise.width(); ++x) noise.at(x, y) = static_cast<std::uint16_t>(random());
  }
  const auto refused = send(*sender, noise);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kTooLarge);
  const auto sent = send(*sender, DepthImage(1280, 1024, 1500));
  EXPECT_TRUE(sent.ok() && *sent);
}

TEST_F(FrameSenderTest, a_calibration_that_is_none_is_refused_before_the_hub_is_asked) {
  auto options = sensor_of("ws://127.0.0.1:1", 64, 48);
  options.calibration.depth.fx = 0;
  const auto refused = FrameSender::open(options, {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace roomcast::sensor
