// SPDX-License-Identifier: Apache-2.0
// Tests the desktop viewer without a headset.
#include "roomcast/viewer/desktop_viewer_fixture.h"

namespace roomcast::viewer {
namespace {

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

TEST_F(DesktopViewerTest, ends_when_its_window_is_closed) {
  SDL_Event close{};
  close.type = SDL_QUIT;
  SDL_PushEvent(&close);
  EXPECT_FALSE(viewer->step());
}

}  // namespace
}  // namespace roomcast::viewer
