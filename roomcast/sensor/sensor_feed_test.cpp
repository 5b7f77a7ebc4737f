// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/sensor_feed.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <thread>
#include <utility>

#include <boost/asio/post.hpp>
#include <gtest/gtest.h>

#include "roomcast/alignment/service/bundle_message.h"
#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"

namespace roomcast::sensor {
namespace {

using namespace std::chrono_literals;

/// State of the test's source, which the feed owns.
struct Watched {
  std::atomic<int> frames{0};
  std::atomic<bool> is_idle{false};
};

/// A striped wall 1.5 m away, 200 times a second.
class Wall final : public source::FrameSource {
 public:
  explicit Wall(Watched& watched) : watched_(watched) {
    description_.name = "wall";
    description_.calibration.depth = {
        .width = 128, .height = 96, .fx = 120, .fy = 120, .cx = 64, .cy = 48};
    description_.calibration.color = description_.calibration.depth;
    description_.calibration.color_is_registered = true;
    description_.fps = 200;
  }
  [[nodiscard]] const source::SensorDescription& description() const override {
    return description_;
  }
  void set_idle(bool is_idle) override { watched_.is_idle = is_idle; }
  [[nodiscard]] Result<bool> next(source::CapturedFrame& frame, std::stop_token stop) override {
    std::this_thread::sleep_for(5ms);
    frame.depth_mm = DepthImage(128, 96, 1500);
    frame.color = ColorImage(128, 96, Rgb8{90, 80, 70});
    for (int y = 0; y < 96; ++y) frame.color.at(40, y) = frame.color.at(80, y) = Rgb8{};
    frame.index = static_cast<std::uint64_t>(watched_.frames++);
    frame.capture_time = SteadyClock().now();
    return !stop.stop_requested();
  }

 private:
  Watched& watched_;
  source::SensorDescription description_;
};

class SensorFeedTest : public testing::Test {
 protected:
  SensorFeedTest() {
    network.start();
    SensorFeedOptions options;
    options.hub_url = hub->url();
    auto started = SensorFeed::start(std::make_unique<Wall>(source), options);
    EXPECT_TRUE(started.ok()) << started.error().message;
    feed = std::move(*started);
  }
  ~SensorFeedTest() override {
    feed.reset();
    network.finish([this] { hub.reset(); });
  }

  void say(const wire::pb::Control& message) {
    boost::asio::post(network.io(), [this, message] { hub->say(message); });
  }
  void say_frames_are(bool wanted) {
    wire::pb::Control demand;
    demand.mutable_frame_demand()->set_wanted(wanted);
    say(demand);
  }

  std::vector<wire::FrameHeader> frames_at_hub() {
    std::promise<std::vector<wire::FrameHeader>> answer;
    boost::asio::post(network.io(), [&] { answer.set_value(hub->frames); });
    return answer.get_future().get();
  }

  /// The last bundle that the feed has sent.
  std::optional<wire::pb::CalibrationBundle> bundle_at_hub() {
    std::promise<std::optional<wire::pb::CalibrationBundle>> answer;
    boost::asio::post(network.io(), [&] {
      std::optional<wire::pb::CalibrationBundle> last;
      for (const wire::pb::Control& control : hub->heard) {
        if (control.has_calibration_bundle()) last = control.calibration_bundle();
      }
      answer.set_value(std::move(last));
    });
    return answer.get_future().get();
  }

  template <class Condition>
  static bool soon(Condition condition) {
    const auto give_up = std::chrono::steady_clock::now() + 20s;
    while (!condition()) {
      if (std::chrono::steady_clock::now() > give_up) return false;
      std::this_thread::sleep_for(1ms);
    }
    return true;
  }

  Watched source;
  client::NetworkThread network;
  std::optional<client::FakeHub> hub{std::in_place, network.io()};
  std::unique_ptr<SensorFeed> feed;
};

TEST_F(SensorFeedTest, while_nobody_watches_it_captures_seldom_and_sends_nothing) {
  ASSERT_TRUE(soon([&] { return frames_at_hub().size() > 3; }));
  say_frames_are(false);
  ASSERT_TRUE(soon([&] { return source.is_idle.load(); }));
  EXPECT_FALSE(feed->stats().frames_wanted);
  const auto sent = feed->stats().frames_sent;
  const int captured = source.frames;
  std::this_thread::sleep_for(1s);
  EXPECT_EQ(feed->stats().frames_sent, sent);
  EXPECT_LE(source.frames - captured, 4) << "200 while somebody watches";
  EXPECT_TRUE(soon([&] { return source.frames > captured + 4; })) << "its place is still watched";
}

TEST_F(SensorFeedTest, the_first_viewer_gets_a_key_frame_without_a_gap_in_the_numbers) {
  ASSERT_TRUE(soon([&] { return frames_at_hub().size() > 3; }));
  say_frames_are(false);
  ASSERT_TRUE(soon([&] { return source.is_idle.load(); }));
  const auto before = frames_at_hub();
  say_frames_are(true);
  std::vector<wire::FrameHeader> after;
  ASSERT_TRUE(soon([&] { return (after = frames_at_hub()).size() > before.size() + 2; }));
  EXPECT_TRUE(after[before.size()].key);
  EXPECT_EQ(after[before.size()].seq, before.back().seq + 1) << "nothing was lost";
  EXPECT_FALSE(source.is_idle);
}

TEST_F(SensorFeedTest, while_nobody_sees_it_it_sends_no_frames_but_tells_what_it_sees) {
  ASSERT_TRUE(soon([&] { return frames_at_hub().size() > 3; }));
  wire::pb::Control demand;
  demand.mutable_frame_demand()->set_wanted(true);
  demand.mutable_frame_demand()->set_unseen(true);
  say(demand);
  ASSERT_TRUE(soon([&] { return source.is_idle.load(); }));
  EXPECT_TRUE(feed->stats().is_watched);
  EXPECT_FALSE(feed->stats().frames_wanted);
  const auto depths_at_hub = [&] {
    std::promise<std::ptrdiff_t> answer;
    boost::asio::post(network.io(), [&] {
      answer.set_value(std::ranges::count_if(
          hub->heard, [](const auto& control) { return control.has_coarse_depth(); }));
    });
    return answer.get_future().get();
  };
  const auto told = depths_at_hub();
  const auto before = frames_at_hub();
  EXPECT_TRUE(soon([&] { return depths_at_hub() > told; }));
  EXPECT_EQ(frames_at_hub().size(), before.size());
  demand.mutable_frame_demand()->set_unseen(false);
  say(demand);
  std::vector<wire::FrameHeader> after;
  ASSERT_TRUE(soon([&] { return (after = frames_at_hub()).size() > before.size(); }));
  EXPECT_TRUE(after[before.size()].key);
}

TEST_F(SensorFeedTest, where_layer_0_suffices_it_sends_no_other) {
  wire::pb::Control demand;
  demand.mutable_frame_demand()->set_wanted(true);
  demand.mutable_frame_demand()->set_base_only(true);
  ASSERT_TRUE(soon([&] { return frames_at_hub().size() > 3; }));
  say(demand);
  const auto newest_are = [&](std::uint8_t layer) {
    const auto frames = frames_at_hub();
    return frames.size() > 6 && std::all_of(frames.end() - 6, frames.end(), [&](const auto& frame) {
             return frame.layer == layer;
           });
  };
  EXPECT_TRUE(soon([&] { return newest_are(0); }));
  demand.mutable_frame_demand()->set_base_only(false);
  say(demand);
  EXPECT_TRUE(soon([&] { return !newest_are(0); }));
}

TEST_F(SensorFeedTest, while_sightings_are_requested_it_captures_at_its_full_rate) {
  wire::pb::Control request;
  request.mutable_sighting_request()->set_heads(true);
  say(request);
  say_frames_are(false);
  ASSERT_TRUE(soon([&] { return !feed->stats().frames_wanted; }));
  const int captured = source.frames;
  EXPECT_TRUE(soon([&] { return source.frames > captured + 60; }));
  EXPECT_FALSE(source.is_idle);
}

TEST_F(SensorFeedTest, it_applies_the_factor_that_the_hub_tells_and_sends_a_bundle_with_it) {
  ASSERT_TRUE(soon([&] { return bundle_at_hub().has_value(); }));
  EXPECT_EQ(bundle_at_hub()->depth_scale(), 1);
  wire::pb::Control told;
  told.mutable_depth_scale()->set_factor(1.04);
  say(told);
  ASSERT_TRUE(soon([&] { return bundle_at_hub()->depth_scale() == 1.04; }));
  const auto calibration = Wall(source).description().calibration;
  const auto bundle = alignment::bundle_from_message(*bundle_at_hub(), "wall", calibration);
  ASSERT_TRUE(bundle.ok()) << bundle.error().message;
  EXPECT_EQ(bundle->depth_mm.at(64, 48), 1560);
}

TEST_F(SensorFeedTest, it_reports_instants_while_they_are_requested) {
  ASSERT_TRUE(soon([&] { return bundle_at_hub().has_value(); }));
  const auto instants = [&] {
    std::promise<std::size_t> answer;
    boost::asio::post(network.io(), [&] {
      answer.set_value(static_cast<std::size_t>(std::ranges::count_if(
          hub->heard, [](const auto& control) { return control.has_depth_instant(); })));
    });
    return answer.get_future().get();
  };
  EXPECT_EQ(instants(), 0U);
  wire::pb::Control request;
  request.mutable_sighting_request()->set_instants(true);
  say(request);
  EXPECT_TRUE(soon([&] { return instants() > 0; })) << "also while nothing moves, now and then";
}

}  // namespace
}  // namespace roomcast::sensor
