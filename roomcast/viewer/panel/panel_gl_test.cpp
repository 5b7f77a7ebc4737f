// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include <SDL2/SDL.h>
#include <gtest/gtest.h>

#include "roomcast/viewer/panel/panel.h"
#include "roomcast/viewer/panel/panel_layer.h"

namespace roomcast::viewer {
namespace {

constexpr PictureSize kSize = {900, 700};
constexpr int kButtons = 70;  // the buttons are above this row of the window
constexpr Rgb8 kRoom = {90, 110, 120};

class PanelTest : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("SDL_VIDEODRIVER", "offscreen", 1);
    ViewWindowOptions options;
    options.size = kSize;
    auto opened = ViewWindow::open(options);
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    window = std::move(*opened);
    auto created = PanelLayer::create(*window);
    ASSERT_TRUE(created.ok()) << created.error().message;
    layer = std::move(*created);
    room.connected = true;
    room.room = "lab";
  }

  /// Draws several frames: Dear ImGui lays out in one frame and draws in the next.
  ColorImage draw() {
    for (int i = 0; i < 3; ++i) {
      auto picture = render::OffscreenTarget::create(kSize.width, kSize.height);
      picture->clear(kRoom);
      window->show(*picture);
      layer->begin();
      PanelFacts facts{room, report.figures(), std::nullopt, toasts};
      pressed = panel.draw(facts, settings);
      layer->end();
    }
    return window->read();
  }

  static int bright_pixels(const ColorImage& picture, int rows) {
    int bright = 0;
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < picture.width(); ++x) bright += picture.at(x, y).g > 200 ? 1 : 0;
    }
    return bright;
  }
  static int changed_pixels(const ColorImage& picture, int x0, int x1) {
    int changed = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = x0; x < x1; ++x) changed += picture.at(x, y) == kRoom ? 0 : 1;
    }
    return changed;
  }

  std::unique_ptr<ViewWindow> window;
  std::unique_ptr<PanelLayer> layer;
  client::RoomSnapshot room;
  RoomReport report;
  std::vector<Toast> toasts;
  ViewSettings settings;
  Panel panel;
  std::optional<ViewerCommand> pressed;
};

TEST_F(PanelTest, lies_at_the_left_and_leaves_the_room_alone) {
  const ColorImage picture = draw();
  EXPECT_GT(changed_pixels(picture, 0, 420), 50'000);
  EXPECT_EQ(changed_pixels(picture, 450, kSize.width), 0);
}

TEST_F(PanelTest, closed_it_draws_nothing) {
  panel.toggle();
  EXPECT_EQ(changed_pixels(draw(), 0, kSize.width), 0);
}

TEST_F(PanelTest, grows_with_each_sensor) {
  const int before = changed_pixels(draw(), 0, 420);
  client::RoomSensor& sensor = room.sensors.emplace_back();
  sensor.name = "left";
  sensor.online = true;
  sensor.pose.source = PoseSource::kGiven;
  sensor.pose.state = PoseState::kValid;
  report.follow(room, HostTime(std::chrono::hours(1)));
  EXPECT_GT(changed_pixels(draw(), 0, 420), before + 2000);
}

TEST_F(PanelTest, disables_recording_where_viewers_may_not_record) {
  const ColorImage without = draw();
  room.rights.may_record = true;
  const ColorImage with = draw();
  EXPECT_GT(bright_pixels(with, kButtons), bright_pixels(without, kButtons));
}

TEST_F(PanelTest, a_toast_stands_at_the_lower_right_even_when_the_panel_is_closed) {
  panel.toggle();
  toasts = {{Toast::Kind::kError, "The hub is lost."}};
  const ColorImage picture = draw();
  EXPECT_NE(picture.at(kSize.width - 40, kSize.height - 30), kRoom);
  int red = 0;
  for (int y = kSize.height - 60; y < kSize.height; ++y) {
    for (int x = 400; x < kSize.width; ++x) red += picture.at(x, y).r > 180 ? 1 : 0;
  }
  EXPECT_GT(red, 50) << "red letters";
}

TEST_F(PanelTest, the_help_stands_in_the_middle) {
  panel.toggle();
  panel.toggle_help();
  const ColorImage picture = draw();
  EXPECT_NE(picture.at(kSize.width / 2, kSize.height / 2), kRoom);
}

TEST_F(PanelTest, keys_walk_even_while_it_is_open) {
  draw();
  SDL_Event key{};
  key.type = SDL_KEYDOWN;
  key.key.keysym.sym = SDLK_w;
  EXPECT_FALSE(layer->take(key));
}

}  // namespace
}  // namespace roomcast::viewer
