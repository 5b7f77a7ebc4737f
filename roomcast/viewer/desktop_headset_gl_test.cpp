// SPDX-License-Identifier: Apache-2.0
// Tests the desktop viewer with a headset.
#include "roomcast/viewer/desktop_viewer_fixture.h"

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

class DesktopHeadsetTest : public DesktopViewerTest {};

TEST_F(DesktopHeadsetTest, goes_on_on_the_desktop_when_the_headset_is_taken_off_or_lost) {
  open_with_headset();
  EXPECT_TRUE(steps_until([&] { return runtime.frames_with_layer > 2; }));
  EXPECT_TRUE(steps_until([&] {
    bool hub_has_hands = false;
    on_hub([&](client::FakeHub& h) {
      const auto& last = h.heard.back();
      hub_has_hands = last.has_viewer_pose() && last.viewer_pose().has_right_hand();
    });
    return hub_has_hands;
  }));
  runtime.take_off();
  const auto frames = runtime.frames;
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(viewer->step());
  EXPECT_EQ(runtime.frames, frames);
  runtime.put_on();
  EXPECT_TRUE(steps_until([&] { return runtime.frames > frames; }));
  runtime.lose_session();
  EXPECT_TRUE(steps_until([&] { return says("the headset is lost"); }));
  const auto drawn = viewer->pictures_drawn();
  press(SDLK_a);
  EXPECT_TRUE(steps_until([&] { return viewer->pictures_drawn() > drawn; }));
  viewer.reset();
  EXPECT_TRUE(runtime.violations.empty());
}

TEST_F(DesktopHeadsetTest, the_wearer_reads_that_the_hub_is_lost) {
  open_with_headset();
  EXPECT_TRUE(steps_until([&] { return runtime.frames_with_layer > 2; }));
  on_hub([](client::FakeHub& h) {
    h.lets_joins_wait = true;
    h.hang_up();
  });
  EXPECT_TRUE(steps_until([&] { return says("The hub is lost"); }));
  const auto frames = runtime.frames;
  EXPECT_TRUE(steps_until([&] { return runtime.frames > frames + 1; }));
  EXPECT_TRUE(runtime.given_board);
}

/// The test runtime's headset asks for its next frame at once, as a very fast one would.
TEST_F(DesktopHeadsetTest, the_screen_does_not_slow_a_headset_down) {
  open_with_headset();
  EXPECT_TRUE(steps_until([&] { return runtime.frames_with_layer > 2; }));
  EXPECT_FALSE(viewer->window().waits_for_screen());
  const auto frames = runtime.frames;
  const auto presented = viewer->window().presented();
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(steps_until([&] { return runtime.frames >= frames + 30; }));
  const auto periods = (std::chrono::steady_clock::now() - begin) / 33ms;
  EXPECT_LE(viewer->window().presented(), presented + static_cast<std::uint64_t>(periods) + 1);
  runtime.take_off();
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(viewer->step());
  EXPECT_TRUE(viewer->window().waits_for_screen());
}

TEST_F(DesktopHeadsetTest, the_desktop_goes_on_while_nobody_sees_the_headsets_frames) {
  open_with_headset();
  EXPECT_TRUE(steps_until([&] { return runtime.frames_with_layer > 2; }));
  runtime.is_seen = false;
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(viewer->step());
  const auto rested = viewer->pictures_drawn();
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(viewer->step());
  EXPECT_LE(viewer->pictures_drawn(), rested + 1) << "frames that nobody sees are not counted";
  const auto frames = runtime.frames;
  press(SDLK_a);
  EXPECT_TRUE(steps_until([&] { return viewer->pictures_drawn() > rested + 2; }));
  press(SDLK_a, false);
  EXPECT_GT(runtime.frames, frames) << "the session goes on";
}

TEST_F(DesktopHeadsetTest, begins_at_the_start_although_the_hub_names_it_later) {
  viewer.reset();
  runtime.reset();
  ::setenv("XR_RUNTIME_JSON", ROOMCAST_TEST_OPENXR, 1);
  auto display = DesktopDisplay::open(options.window);
  ASSERT_TRUE(display.ok()) << display.error().message;
  DesktopState state(options.settings, std::nullopt);
  const HostTime begin{1h};
  ASSERT_TRUE(display->poll_headset(begin));
  EXPECT_FALSE(display->poll_headset(begin));
  ASSERT_TRUE(display->draw_headset(state, begin).ok());
  auto room = std::make_shared<client::RoomSnapshot>();
  room->revision = 1;
  room->connected = true;
  room->start_pose = RigidTransform{Eigen::Matrix3d::Identity(), {4, 1.2, 7}};
  state.follow(room, begin);
  const Eigen::Vector3d start_m(4, 1.6, 7);  // at the wearer's height
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(display->draw_headset(state, begin).ok());
    EXPECT_LT((display->headset_pose().world_from_head.translation_m - start_m).norm(), 1e-5);
  }
}

TEST_F(DesktopHeadsetTest, who_leaves_the_headset_is_not_brought_back_unasked) {
  viewer.reset();
  runtime.reset();
  ::setenv("XR_RUNTIME_JSON", ROOMCAST_TEST_OPENXR, 1);
  auto display = DesktopDisplay::open(options.window);
  ASSERT_TRUE(display.ok()) << display.error().message;
  const HostTime begin{1h}, later = begin + 1h;
  ASSERT_TRUE(display->poll_headset(begin));
  EXPECT_FALSE(display->poll_headset(begin));
  ASSERT_TRUE(display->headset_runs());
  runtime.ask_for_end();
  const auto news = display->poll_headset(begin);
  ASSERT_TRUE(news);
  EXPECT_NE(news->sentence.find("the headset was put away; press C to go back"), std::string::npos)
      << news->sentence;
  EXPECT_FALSE(display->poll_headset(later));
  display->recenter_headset();
  EXPECT_TRUE(display->poll_headset(later)) << "asked for";
  EXPECT_FALSE(display->poll_headset(later));
  EXPECT_TRUE(display->headset_runs());
  runtime.lose_session();
  ASSERT_TRUE(display->poll_headset(later));
  EXPECT_TRUE(display->poll_headset(later + 1min)) << "a loss is no farewell";
}

TEST_F(DesktopHeadsetTest, without_a_headset_reports_that_and_shows_the_room) {
  ::setenv("XR_RUNTIME_JSON", "/nonexistent/runtime.json", 1);
  ::setenv("XR_LOADER_DEBUG", "none", 1);
  options.headset = true;
  std::vector<std::string> log;
  options.log = [&log](LogLevel, std::string_view line) { log.emplace_back(line); };
  open();
  EXPECT_TRUE(steps_until([&] { return says("The room is shown on the desktop only"); }));
  EXPECT_TRUE(steps_until([&] { return viewer->pictures_drawn() > 0; }));
  ASSERT_EQ(log.size(), 1U) << "once, not at each try";
  EXPECT_NE(log[0].find("XR_RUNTIME_JSON is \"/nonexistent/runtime.json\""), std::string::npos);
}

TEST_F(DesktopHeadsetTest, logs_the_headset_that_comes_and_goes) {
  std::vector<std::string> log;
  options.log = [&log](LogLevel, std::string_view line) { log.emplace_back(line); };
  open_with_headset();
  EXPECT_TRUE(steps_until([&] { return log.size() == 1; }));
  EXPECT_EQ(log[0], "The headset is connected.");
  EXPECT_TRUE(steps_until([&] { return runtime.frames_with_layer > 0; }));
  runtime.lose_session();
  EXPECT_TRUE(steps_until([&] { return log.size() == 2; }));
  EXPECT_EQ(log[1], "The room is shown on the desktop only: the headset is lost.");
}

}  // namespace
}  // namespace roomcast::viewer
