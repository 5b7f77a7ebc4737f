// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include <SDL2/SDL.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include "roomcast/viewer/panel/panel.h"
#include "roomcast/viewer/panel/panel_layer.h"
#include "roomcast/viewer/panel/voice_panel.h"

namespace roomcast::viewer {
namespace {

constexpr PictureSize kSize = {900, 700};
constexpr int kButtons = 70;  // the buttons are above this row of the window
constexpr Rgb8 kRoom = {90, 110, 120};

class PanelTest : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("SDL_VIDEODRIVER", "offscreen", 1);
    open(kSize);
    room.connected = true;
    room.room = "lab";
  }
  void open(PictureSize size) {
    layer.reset();
    window.reset();
    ViewWindowOptions options;
    options.size = size;
    auto opened = ViewWindow::open(options);
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    window = std::move(*opened);
    auto created = PanelLayer::create(*window);
    ASSERT_TRUE(created.ok()) << created.error().message;
    layer = std::move(*created);
  }

  /// Draws several frames: Dear ImGui lays out in one frame and draws in the next.
  ColorImage draw() {
    for (int i = 0; i < 3; ++i) {
      auto picture = render::OffscreenTarget::create(window->size().width, window->size().height);
      picture->clear(kRoom);
      window->show(*picture);
      layer->begin();
      PanelFacts facts{room, report.figures(), std::nullopt, toasts};
      facts.no_headset = no_headset;
      facts.voice = voice;
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
  static int red_pixels(const ColorImage& picture, int from_row) {
    int red = 0;
    for (int y = from_row; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x)
        red += picture.at(x, y).r > 180 && picture.at(x, y).g < 140 ? 1 : 0;
    }
    return red;
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
  std::string no_headset;
  std::optional<VoiceFacts> voice;
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

TEST_F(PanelTest, has_a_part_for_voice_with_a_volume_for_everybody_who_was_heard) {
  const int without = changed_pixels(draw(), 0, 420);
  voice.emplace();
  const int silent = changed_pixels(draw(), 0, 420);
  EXPECT_GT(silent, without);
  auto& person = room.people.emplace_back();
  person.id = ViewerId{4};
  voice->heard = {ViewerId{4}, ViewerId{5}};  // who has left has none
  settings.voice.microphone_on = true;
  voice->microphone_problem = "an admin has muted you: nobody hears you";
  EXPECT_GT(changed_pixels(draw(), 0, 420), silent);
  EXPECT_TRUE(settings.voice.microphone_on) << "nobody has pressed anything";
}

TEST(VoicePanel, the_meter_shows_decibels) {
  EXPECT_EQ(meter_of(1), 1);
  EXPECT_NEAR(meter_of(0.0316), 0.5, 0.01);
  EXPECT_EQ(meter_of(0), 0);
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

TEST_F(PanelTest, a_toast_can_be_read_in_a_narrow_window_over_the_panel) {
  toasts = {{Toast::Kind::kError, "The hub is lost."}};
  panel.toggle();
  const int red_letters = red_pixels(draw(), kSize.height - 60);
  panel.toggle();
  open({380, 420});
  for (int i = 0; i < 2; ++i) {
    const ColorImage picture = draw();
    EXPECT_GE(red_pixels(picture, 360), red_letters * 9 / 10);
    EXPECT_EQ(picture.at(190, 364), picture.at(190, 366)) << "the panel ends above it";
    ImGui::SetWindowFocus("roomcast");  // as a click does
  }
}

TEST_F(PanelTest, says_for_as_long_as_it_is_true_why_there_is_no_headset) {
  const int without = changed_pixels(draw(), 0, 420);
  no_headset = "The room is shown on the desktop only: no headset is connected.";
  EXPECT_GT(changed_pixels(draw(), 0, 420), without + 2000);
  EXPECT_GT(changed_pixels(draw(), 0, 420), without + 2000);
}

TEST_F(PanelTest, the_help_can_be_read_over_the_panel) {
  panel.toggle_help();
  const ColorImage over_panel = draw();
  panel.toggle();
  const ColorImage over_room = draw();
  for (int y = 200; y < 500; ++y) {
    for (int x = 180; x < 720; ++x) ASSERT_EQ(over_panel.at(x, y), over_room.at(x, y));
  }
}

TEST_F(PanelTest, the_help_has_more_lines_for_headsets_and_fits_into_small_windows) {
  panel.toggle();
  panel.toggle_help();
  const int without = changed_pixels(draw(), 0, kSize.width);
  no_headset = "There is none.";
  EXPECT_GT(changed_pixels(draw(), 0, kSize.width), without + 20'000);
  open({320, 240});
  const ColorImage small = draw();
  EXPECT_EQ(small.at(160, 5), kRoom) << "its margin";
  EXPECT_EQ(small.at(160, 235), kRoom);
  EXPECT_NE(small.at(160, 120), kRoom);
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
