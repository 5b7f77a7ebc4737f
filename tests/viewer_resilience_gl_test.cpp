// SPDX-License-Identifier: Apache-2.0
// A desktop viewer with a real hub and real sensors, which are stopped and started again: the
// viewer keeps drawing, reports what is missing, and resumes. The window needs no display.
#include <cstdlib>
#include <thread>

#include <SDL2/SDL.h>
#include <gtest/gtest.h>

#include "roomcast/client/publisher.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/hub/server/running_hub.h"
#include "roomcast/viewer/desktop_viewer.h"

namespace roomcast::tests {
namespace {

using namespace std::chrono_literals;

constexpr int kSide = 64;
constexpr Rgb8 kWall = {200, 60, 40};

/// A sensor at the world's origin that sees a wall.
class WallSensor {
 public:
  explicit WallSensor(const std::string& hub_url) {
    client::PublisherOptions options;
    options.hub_url = hub_url;
    options.name = "left";
    options.calibration.depth = {
        .width = kSide, .height = kSide, .fx = 60, .fy = 60, .cx = 31.5, .cy = 31.5};
    options.calibration.color = options.calibration.depth;
    options.calibration.color_is_registered = true;
    options.world_from_depth = world_from_optical_looking_at({0, 1.6, 0}, {0, 1.6, -1});
    options.fps = 20;
    auto opened = client::Publisher::open(options);
    EXPECT_TRUE(opened.ok()) << opened.error().message;
    publisher_ = std::move(*opened);
    codec::FrameEncoderOptions encoding;
    encoding.width = encoding.height = kSide;
    encoding.depth_mode = codec::DepthMode::kLossless;
    encoder_ = std::move(*codec::FrameEncoder::create(encoding));
  }

  /// Sends a frame if one is due.
  void send() {
    const auto turn = publisher_->next_turn();
    if (!turn) return;
    auto message = client::Publisher::begin_frame();
    const auto info = encoder_->encode(depth_, color_, seen_, turn->want_key, message.appendable());
    EXPECT_TRUE(info.ok());
    static_cast<void>(publisher_->publish(*turn, *info, SteadyClock().now(), std::move(message)));
  }

 private:
  DepthImage depth_{kSide, kSide, 2000};
  ColorImage color_{kSide, kSide, kWall};
  MaskImage seen_{kSide, kSide, 255};
  std::unique_ptr<client::Publisher> publisher_;
  std::unique_ptr<codec::FrameEncoder> encoder_;
};

class ViewerResilience : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("SDL_VIDEODRIVER", "offscreen", 1);
    sensor.emplace(hub->url());
    auto joined =
        client::Subscriber::open({.hub_url = hub->url(), .room = {}, .name = {}, .log = {}});
    ASSERT_TRUE(joined.ok()) << joined.error().message;
    subscriber = std::move(*joined);
    viewer::DesktopViewerOptions options;
    options.window.size = {640, 480};
    options.settings.mode = render::RenderMode::kMesh;
    options.start = viewer::look_from({0, 1.6, 0}, {0, 1.6, -2});
    options.panel = false;
    options.write_png = [](const auto&, ColorView) { return Status{}; };
    auto opened = viewer::DesktopViewer::open(*subscriber, options);
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    viewer = std::move(*opened);
    ASSERT_TRUE(rounds_until([&] { return shows_wall(); })) << "the wall never came";
  }

  template <class Wanted>
  bool rounds_until(Wanted wanted) {
    const auto give_up = std::chrono::steady_clock::now() + 15s;
    while (!wanted() && std::chrono::steady_clock::now() < give_up) {
      if (sensor) sensor->send();
      viewer->step();
    }
    return wanted();
  }

  bool shows_wall() {
    const Rgb8 middle = viewer->window_picture().at(320, 200);
    return middle.r > 150 && middle.g < 110;
  }

  bool says(const std::string& words) {
    for (const viewer::Toast& toast : viewer->toasts()) {
      if (toast.sentence.find(words) != std::string::npos) return true;
    }
    return false;
  }

  /// Expects a new picture at once when the user turns the head.
  void expect_goes_on_drawing() {
    const auto before = viewer->pictures_drawn();
    const auto begin = std::chrono::steady_clock::now();
    SDL_Event motion{};
    motion.type = SDL_MOUSEMOTION;
    motion.motion.state = SDL_BUTTON_LMASK;
    motion.motion.xrel = 4;
    SDL_PushEvent(&motion);
    // SDL may deliver an event one step later.
    for (int i = 0; i < 3 && viewer->pictures_drawn() == before; ++i) viewer->step();
    EXPECT_GT(viewer->pictures_drawn(), before);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 2s) << "the viewer waited";
  }

  std::optional<hub::RunningHub> hub{std::in_place};
  std::optional<WallSensor> sensor;
  std::unique_ptr<client::Subscriber> subscriber;
  std::unique_ptr<viewer::DesktopViewer> viewer;
};

TEST_F(ViewerResilience, without_its_hub_it_shows_the_last_pictures_and_resumes) {
  const std::uint16_t port = hub->port();
  hub.reset();
  sensor.reset();
  EXPECT_TRUE(rounds_until([&] { return says("The hub is lost"); }));
  EXPECT_TRUE(shows_wall()) << "the last pictures stay";
  expect_goes_on_drawing();
  hub.emplace(hub::HubOptions{}, port);
  EXPECT_TRUE(rounds_until([&] { return says("The hub is back"); }));
  sensor.emplace(hub->url());
  EXPECT_TRUE(rounds_until([&] { return shows_wall() && !says("No sensor"); }));
}

TEST_F(ViewerResilience, without_a_sensor_it_names_the_missing_one_and_resumes) {
  sensor.reset();
  EXPECT_TRUE(rounds_until([&] { return says("All sensors are gone"); }));
  expect_goes_on_drawing();
  sensor.emplace(hub->url());
  EXPECT_TRUE(rounds_until([&] { return shows_wall(); }));
  EXPECT_TRUE(rounds_until([&] { return says("There is something to see again"); }));
}

}  // namespace
}  // namespace roomcast::tests
