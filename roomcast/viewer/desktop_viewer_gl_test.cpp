// SPDX-License-Identifier: Apache-2.0
// Tests the whole desktop viewer in a window without a display (SDL_VIDEODRIVER=offscreen), with a
// fake hub.
#include <cstdlib>

#include <SDL2/SDL.h>
#include <gtest/gtest.h>

#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/core/temporary_folder.h"
#include "roomcast/viewer/desktop_viewer.h"
#include "roomcast/viewer/xr/test_runtime/test_runtime.h"

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

constexpr PictureSize kSize = {320, 240};

class DesktopViewerTest : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("SDL_VIDEODRIVER", "offscreen", 1);
    network.start();
    auto joined =
        client::Subscriber::open({.hub_url = hub->url(), .room = {}, .name = "Ada", .log = {}});
    ASSERT_TRUE(joined.ok()) << joined.error().message;
    subscriber = std::move(*joined);
    options.window.size = kSize;
    options.settings.mode = render::RenderMode::kMesh;
    options.panel = false;
    options.pictures = folder.path();
    options.write_png = [this](const auto& path, ColorView picture) {
      written.push_back(path.filename().string());
      written_size = {picture.width, picture.height};
      return Status{};
    };
    open();
  }
  void open() {
    viewer.reset();
    auto opened = DesktopViewer::open(*subscriber, options);
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    viewer = std::move(*opened);
  }
  void open_with_headset() {
    runtime.reset();
    ::setenv("XR_RUNTIME_JSON", ROOMCAST_TEST_OPENXR, 1);
    options.headset = true;
    open();
  }
  void TearDown() override {
    viewer.reset();
    subscriber.reset();
    network.finish([this] { hub.reset(); });
  }

  template <class Action>
  void on_hub(Action action) {
    network.run([&] { action(*hub); });
  }

  /// The hub disconnects and sends the new permission to reconnecting viewers.
  void reconnect_with_recording(bool lets) {
    on_hub([lets](client::FakeHub& h) {
      h.lets_record = lets;
      h.hang_up();
    });
    EXPECT_TRUE(steps_until([&] {
      const auto room = subscriber->snapshot();
      return room->connected && room->rights.may_record == lets;
    }));
  }

  /// Calls step() until `wanted` is true.
  template <class Wanted>
  bool steps_until(Wanted wanted) {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    while (!wanted() && std::chrono::steady_clock::now() < give_up) {
      if (!viewer->step()) return wanted();
    }
    return wanted();
  }

  static void press(SDL_Keycode key, bool down = true) {
    SDL_Event event{};
    event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
    event.key.keysym.sym = key;
    event.key.keysym.scancode = SDL_GetScancodeFromKey(key);
    SDL_PushEvent(&event);
  }

  bool says(const std::string& words) {
    for (const Toast& toast : viewer->toasts()) {
      if (toast.sentence.find(words) != std::string::npos) return true;
    }
    return false;
  }

  client::NetworkThread network;
  std::optional<client::FakeHub> hub{std::in_place, network.io()};
  std::unique_ptr<client::Subscriber> subscriber;
  TemporaryFolder folder;
  DesktopViewerOptions options;
  std::vector<std::string> written;
  PictureSize written_size;
  std::unique_ptr<DesktopViewer> viewer;
  xr::TestRuntime& runtime = xr::TestRuntime::instance();
};

TEST_F(DesktopViewerTest, draws_an_empty_room_and_reports_that_it_is_empty) {
  EXPECT_TRUE(steps_until([&] { return viewer->pictures_drawn() > 0; }));
  EXPECT_TRUE(steps_until([&] { return says("No sensor is in the room yet."); }));
  const ColorImage picture = viewer->window_picture();
  EXPECT_EQ(picture.width(), kSize.width);
  EXPECT_EQ(picture.at(160, 5), render::RenderOptions{}.background);
}

TEST_F(DesktopViewerTest, walks_and_sends_its_pose_to_the_hub) {
  EXPECT_TRUE(steps_until([&] { return viewer->pictures_drawn() > 0; }));
  const Eigen::Vector3d before = viewer->view().position_m;
  press(SDLK_w);
  EXPECT_TRUE(steps_until([&] { return (viewer->view().position_m - before).norm() > 0.3; }));
  press(SDLK_w, false);
  const auto hub_has_pose = [&] {
    bool has_pose = false;
    const Eigen::Vector3d here = viewer->view().position_m;
    on_hub([&](client::FakeHub& h) {
      const auto& last = h.heard.back();
      has_pose =
          last.has_viewer_pose() && std::abs(last.viewer_pose().head().z() - here.z()) < 1e-4;
    });
    return has_pose;
  };
  EXPECT_TRUE(steps_until(hub_has_pose));
}

TEST_F(DesktopViewerTest, starts_at_the_hubs_start_position_and_returns_to_it) {
  EXPECT_TRUE(steps_until([&] { return viewer->pictures_drawn() > 0; }));
  const Eigen::Vector3d start = viewer->view().position_m;
  EXPECT_EQ(start, world_from_start_view(*subscriber->snapshot()).translation_m);
  press(SDLK_d);
  EXPECT_TRUE(steps_until([&] { return (viewer->view().position_m - start).norm() > 0.1; }));
  press(SDLK_d, false);
  press(SDLK_r);
  EXPECT_TRUE(steps_until([&] { return (viewer->view().position_m - start).norm() < 1e-9; }));
}

TEST_F(DesktopViewerTest, rests_while_nothing_happens) {
  EXPECT_TRUE(steps_until([&] { return viewer->pictures_drawn() > 0; }));
  const auto drawn = viewer->pictures_drawn();
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(viewer->step());
  EXPECT_LE(viewer->pictures_drawn(), drawn + 1);
}

TEST_F(DesktopViewerTest, shows_panel_and_help_on_command) {
  EXPECT_TRUE(steps_until([&] { return says("No sensor"); }));
  const ColorImage plain = viewer->window_picture();
  press(SDLK_TAB);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(viewer->step());
  const ColorImage with_panel = viewer->window_picture();
  EXPECT_NE(plain.at(30, 30), with_panel.at(30, 30));
  press(SDLK_h);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(viewer->step());
  EXPECT_NE(with_panel.at(300, 120), viewer->window_picture().at(300, 120));
}

TEST_F(DesktopViewerTest, saves_screenshots_without_the_panel) {
  press(SDLK_TAB);
  EXPECT_TRUE(steps_until([&] { return viewer->pictures_drawn() > 0; }));
  press(SDLK_p);
  EXPECT_TRUE(steps_until([&] { return !written.empty(); }));
  EXPECT_EQ(written[0], "roomcast-lab-0001.png");
  EXPECT_EQ(written_size, kSize);
  EXPECT_TRUE(says("Saved as"));
}

TEST_F(DesktopViewerTest, captures_have_the_windows_size_although_fewer_pixels_are_drawn) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);  // without ffmpeg
  options.settings.automatic_scale = false;
  options.settings.render_scale = 0.25;
  open();
  EXPECT_TRUE(steps_until([&] { return viewer->pictures_drawn() > 0; }));
  press(SDLK_p);
  EXPECT_TRUE(steps_until([&] { return !written.empty(); }));
  EXPECT_EQ(written_size, kSize);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(viewer->step());  // small pictures again
  written_size = {};
  press(SDLK_v);
  press(SDLK_a);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(viewer->step());
  press(SDLK_a, false);
  press(SDLK_v);
  EXPECT_TRUE(steps_until([&] { return says("-video."); }));
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(written.back().substr(0, 6), "frame-");
  EXPECT_EQ(written_size, kSize);
}

TEST_F(DesktopViewerTest, records_a_video_until_the_second_command) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);  // without ffmpeg
  EXPECT_TRUE(steps_until([&] { return viewer->pictures_drawn() > 0; }));
  press(SDLK_v);
  press(SDLK_a);  // any input
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(viewer->step());
  press(SDLK_a, false);
  press(SDLK_v);
  EXPECT_TRUE(steps_until([&] { return says("Saved as"); }));
  ::setenv("PATH", path.c_str(), 1);
  ASSERT_FALSE(written.empty());
  EXPECT_EQ(written[0], "frame-000001.png");
}

TEST_F(DesktopViewerTest, saves_nothing_where_viewers_may_not_record) {
  reconnect_with_recording(false);
  EXPECT_TRUE(steps_until([&] { return viewer->pictures_drawn() > 0; }));
  press(SDLK_p);
  EXPECT_TRUE(steps_until([&] { return says("this room does not let viewers record"); }));
  press(SDLK_v);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(viewer->step());
  EXPECT_FALSE(says("Recording"));
  EXPECT_TRUE(written.empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(DesktopViewerTest, a_video_ends_when_viewers_may_no_longer_record) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);  // without ffmpeg
  EXPECT_TRUE(steps_until([&] { return viewer->pictures_drawn() > 0; }));
  press(SDLK_v);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(viewer->step());
  reconnect_with_recording(false);
  EXPECT_TRUE(steps_until([&] { return says("this room does not let viewers record"); }));
  EXPECT_TRUE(says("Saved as"));
  ::setenv("PATH", path.c_str(), 1);
}

TEST_F(DesktopViewerTest, keeps_drawing_without_its_hub_reports_the_loss_and_resumes) {
  EXPECT_TRUE(steps_until([&] { return says("No sensor"); }));
  const auto hang_up_and_let_wait = [&](bool wait) {
    on_hub([wait](client::FakeHub& h) {
      h.lets_joins_wait = wait;
      h.hang_up();
    });
  };
  hang_up_and_let_wait(true);
  EXPECT_TRUE(steps_until([&] { return says("The hub is lost"); }));
  const auto drawn = viewer->pictures_drawn();
  press(SDLK_a);
  EXPECT_TRUE(steps_until([&] { return viewer->pictures_drawn() > drawn + 1; }));
  hang_up_and_let_wait(false);
  EXPECT_TRUE(steps_until([&] { return says("The hub is back"); }));
}

TEST_F(DesktopViewerTest, shows_the_other_people) {
  EXPECT_TRUE(steps_until([&] { return viewer->pictures_drawn() > 0; }));
  const ColorImage alone = viewer->window_picture();
  on_hub([&](client::FakeHub& h) {
    wire::pb::Control roster;
    auto& entry = *roster.mutable_roster()->add_viewers();
    entry.set_id(9);
    entry.set_name("Grace");
    entry.set_color_rgb(0x2060F0);
    h.say(roster);
    client::PersonPose pose;
    pose.world_from_head =
        world_from_view(viewer->view()) * RigidTransform{Eigen::Matrix3d::Identity(), {0, 0, -1}};
    wire::pb::Control poses;
    *poses.mutable_viewer_poses()->add_poses() = client::message_from_pose(pose);
    poses.mutable_viewer_poses()->mutable_poses(0)->set_viewer_id(9);
    h.say(poses);
  });
  EXPECT_TRUE(steps_until([&] {
    const Rgb8 middle = viewer->window_picture().at(kSize.width / 2, kSize.height / 2);
    return middle.b > 100 && middle.b > middle.r;
  }));
}

TEST_F(DesktopViewerTest, goes_on_on_the_desktop_when_the_headset_is_taken_off_or_lost) {
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

TEST_F(DesktopViewerTest, the_wearer_reads_that_the_hub_is_lost) {
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
TEST_F(DesktopViewerTest, the_screen_does_not_slow_a_headset_down) {
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

TEST_F(DesktopViewerTest, the_desktop_goes_on_while_nobody_sees_the_headsets_frames) {
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

TEST_F(DesktopViewerTest, who_leaves_the_headset_is_not_brought_back_unasked) {
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

TEST_F(DesktopViewerTest, without_a_headset_reports_that_and_shows_the_room) {
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

TEST_F(DesktopViewerTest, logs_the_headset_that_comes_and_goes) {
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

TEST_F(DesktopViewerTest, ends_when_its_window_is_closed) {
  SDL_Event close{};
  close.type = SDL_QUIT;
  SDL_PushEvent(&close);
  EXPECT_FALSE(viewer->step());
}

}  // namespace
}  // namespace roomcast::viewer
