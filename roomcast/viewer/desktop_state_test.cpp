// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/desktop_state.h"

#include <gtest/gtest.h>

#include "roomcast/viewer/view/room_view.h"

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

constexpr PictureSize kDesktopWindow = {640, 480}, kEye = {1680, 1760};
constexpr bool kIsPointing = true;

HostTime desktop_time(nanoseconds since_start) {
  return HostTime(1h + since_start);
}

/// A room with one sensor, whose newest picture has this number.
std::shared_ptr<client::RoomSnapshot> desktop_room(std::uint64_t revision, std::uint32_t seq = 1) {
  auto picture = std::make_shared<client::SensorPicture>();
  picture->seq = seq;
  picture->received = picture->decoded = desktop_time(0s);
  auto room = std::make_shared<client::RoomSnapshot>();
  room->revision = revision;
  room->connected = true;
  room->start_pose = RigidTransform{Eigen::Matrix3d::Identity(), {1, 1.7, 4}};
  client::RoomSensor& sensor = room->sensors.emplace_back();
  sensor.id = SensorId{1};
  sensor.online = true;
  sensor.pose.source = PoseSource::kGiven;
  sensor.pose.state = PoseState::kValid;
  sensor.picture = std::move(picture);
  return room;
}

DesktopState state_at_default_start() {
  return DesktopState(ViewSettings{}, ViewState{});
}

/// Draws and shows a picture, as DesktopViewer does.
void draw_and_show(DesktopState& state, HostTime now,
                   std::optional<nanoseconds> drawing_time = {}) {
  state.drawn({now, state.camera(kDesktopWindow), drawing_time, kDesktopWindow});
  state.shown(now);
}

TEST(DesktopState, starts_at_the_position_given_by_the_hub) {
  DesktopState state(ViewSettings{}, std::nullopt);
  EXPECT_TRUE(state.follow(desktop_room(1), desktop_time(0s)));
  EXPECT_EQ(state.view().position_m, Eigen::Vector3d(1, 1.7, 4));
}

TEST(DesktopState, starts_at_its_own_position_if_it_has_one) {
  ViewState start;
  start.position_m = {5, 1, 5};
  DesktopState state(ViewSettings{}, start);
  state.follow(desktop_room(1), desktop_time(0s));
  EXPECT_EQ(state.view().position_m, start.position_m);
  state.navigation().go_to(ViewState{});
  state.go_to_start();
  EXPECT_EQ(state.view().position_m, start.position_m);
}

TEST(DesktopState, stays_where_the_user_walked_before_the_room_was_known) {
  DesktopState state(ViewSettings{}, std::nullopt);
  state.navigation().hold(WalkKey::kForward, true);
  state.advance(0.05);
  state.navigation().hold(WalkKey::kForward, false);
  const Eigen::Vector3d here = state.view().position_m;
  state.follow(desktop_room(1), desktop_time(0s));
  EXPECT_EQ(state.view().position_m, here);
}

TEST(DesktopState, stays_where_the_user_dragged_the_view_before_the_room_was_known) {
  DesktopState state(ViewSettings{}, std::nullopt);
  state.navigation().drag(Drag::kOrbit, 40, 0, kDesktopWindow.height, 1);
  const Eigen::Vector3d here = state.view().position_m;
  state.advance(0);
  state.follow(desktop_room(1), desktop_time(0s));
  EXPECT_EQ(state.view().position_m, here);
}

TEST(DesktopState, waits_for_a_connection_before_it_goes_to_the_start) {
  DesktopState state(ViewSettings{}, std::nullopt);
  auto offline = desktop_room(1);
  offline->connected = false;
  state.follow(offline, desktop_time(0s));
  EXPECT_EQ(state.view().position_m, ViewState{}.position_m);
}

TEST(DesktopState, draws_once_and_again_only_after_a_change) {
  DesktopState state = state_at_default_start();
  EXPECT_TRUE(state.must_draw(kDesktopWindow, !kIsPointing));
  draw_and_show(state, desktop_time(0s));
  EXPECT_FALSE(state.must_draw(kDesktopWindow, !kIsPointing));
  state.redraw();
  EXPECT_TRUE(state.must_draw(kDesktopWindow, !kIsPointing));
}

TEST(DesktopState, draws_again_after_each_kind_of_change) {
  DesktopState state = state_at_default_start();
  const auto must_draw_after = [&](auto change) {
    draw_and_show(state, desktop_time(0s));
    change();
    state.advance(0);
    return state.must_draw(kDesktopWindow, !kIsPointing);
  };
  EXPECT_FALSE(must_draw_after([] {}));
  EXPECT_TRUE(must_draw_after([&] { state.settings().mode = render::RenderMode::kPoints; }));
  EXPECT_TRUE(must_draw_after([&] { state.settings().unseen = render::Unseen::kBackground; }));
  EXPECT_TRUE(must_draw_after([&] { state.settings().floor_grid = false; }));
  EXPECT_TRUE(must_draw_after([&] { state.settings().hidden = {SensorId{1}}; }));
  EXPECT_TRUE(must_draw_after([&] { state.settings().vertical_fov_rad = 1.2; }));
  EXPECT_TRUE(must_draw_after([&] { state.navigation().zoom(1); }));
  EXPECT_TRUE(must_draw_after([&] { state.follow(desktop_room(7), desktop_time(0s)); }));
  EXPECT_FALSE(must_draw_after([&] { state.follow(desktop_room(7), desktop_time(0s)); }));
}

TEST(DesktopState, draws_again_for_a_window_of_another_size) {
  DesktopState state = state_at_default_start();
  draw_and_show(state, desktop_time(0s));
  EXPECT_TRUE(state.must_draw({800, 600}, !kIsPointing));
}

TEST(DesktopState, draws_while_the_user_points_and_once_after) {
  DesktopState state = state_at_default_start();
  draw_and_show(state, desktop_time(0s));
  EXPECT_TRUE(state.must_draw(kDesktopWindow, kIsPointing));
  state.point_at(Eigen::Vector3d(0, 1, 0));
  draw_and_show(state, desktop_time(0s));
  EXPECT_TRUE(state.must_draw(kDesktopWindow, !kIsPointing)) << "the beam is still in the picture";
  state.point_at(std::nullopt);
  draw_and_show(state, desktop_time(0s));
  EXPECT_FALSE(state.must_draw(kDesktopWindow, !kIsPointing));
}

TEST(DesktopState, shows_the_window_after_a_change_and_ten_times_a_second) {
  DesktopState state = state_at_default_start();
  EXPECT_TRUE(state.must_show(desktop_time(0s)));
  draw_and_show(state, desktop_time(0s));
  EXPECT_FALSE(state.must_show(desktop_time(99ms)));
  EXPECT_TRUE(state.must_show(desktop_time(100ms)));
  state.redraw();
  EXPECT_TRUE(state.must_show(desktop_time(1ms)));
}

TEST(DesktopState, own_pose_has_the_head_and_the_beam) {
  DesktopState state = state_at_default_start();
  EXPECT_EQ(state.own_pose().world_from_head.translation_m, state.view().position_m);
  EXPECT_FALSE(state.own_pose().pointer);
  state.point_at(Eigen::Vector3d(0, 1, 0));
  ASSERT_TRUE(state.own_pose().pointer);
  EXPECT_EQ(state.own_pose().pointer->to_m, Eigen::Vector3d(0, 1, 0));
  EXPECT_LT((state.own_pose().pointer->from_m - state.view().position_m).norm(), 0.5);
}

TEST(DesktopState, a_command_chooses_the_drawing_mode) {
  DesktopState state = state_at_default_start();
  state.choose_mode(ViewerCommand::kModeSplats);
  EXPECT_EQ(state.settings().mode, render::RenderMode::kSplats);
  state.choose_mode(ViewerCommand::kModeBlend);
  EXPECT_EQ(state.settings().mode, render::RenderMode::kBlend);
}

TEST(DesktopState, resolution_follows_the_settings) {
  ViewSettings settings;
  settings.automatic_scale = false;
  settings.render_scale = 0.5;
  const DesktopState state(settings, ViewState{});
  EXPECT_EQ(state.camera(kDesktopWindow).width, kDesktopWindow.width / 2);
  EXPECT_EQ(state.camera({1, 1}).height, 1) << "at least one pixel";
}

TEST(DesktopState, slow_pictures_lower_the_resolution_unless_they_are_captured) {
  DesktopState state = state_at_default_start();
  const auto draw_slowly = [&](bool is_captured) {
    state.draw_at_full_size(is_captured);
    for (std::size_t i = 0; i < RenderScale::kDrawsToJudge; ++i) {
      state.drawn({desktop_time(0s), state.camera(kDesktopWindow), 200ms, kDesktopWindow});
    }
    return state.camera(kDesktopWindow).width;
  };
  EXPECT_EQ(draw_slowly(true), kDesktopWindow.width);
  EXPECT_LT(draw_slowly(false), kDesktopWindow.width);
  EXPECT_EQ(draw_slowly(true), kDesktopWindow.width) << "captured in the window's size";
}

TEST(DesktopState, pictures_of_the_headset_change_neither_resolution_nor_window_picture) {
  DesktopState state = state_at_default_start();
  for (std::size_t i = 0; i < RenderScale::kDrawsToJudge; ++i) {
    state.drawn({desktop_time(0s), std::nullopt, 200ms, kEye});
  }
  EXPECT_EQ(state.camera(kDesktopWindow).width, kDesktopWindow.width);
  EXPECT_FALSE(state.drawn_camera());
  EXPECT_EQ(state.pictures_drawn(), RenderScale::kDrawsToJudge);
}

TEST(DesktopState, latency_counts_each_sensor_picture_once) {
  DesktopState state = state_at_default_start();
  state.follow(desktop_room(1), desktop_time(0s));
  draw_and_show(state, desktop_time(20ms), 4ms);
  draw_and_show(state, desktop_time(500ms), 4ms);  // the same picture again
  const auto stages = state.latency(desktop_time(600ms));
  ASSERT_TRUE(stages);
  EXPECT_DOUBLE_EQ(stages->waiting_ms, 20);
  EXPECT_DOUBLE_EQ(stages->drawing_ms, 4);
  state.follow(desktop_room(2, 2), desktop_time(700ms));
  draw_and_show(state, desktop_time(700ms), 4ms);
  EXPECT_GT(state.latency(desktop_time(700ms))->waiting_ms, 20);
}

TEST(DesktopState, reports_problems_of_the_room_four_times_a_second) {
  DesktopState state = state_at_default_start();
  auto empty = std::make_shared<client::RoomSnapshot>();
  empty->revision = 1;
  empty->connected = true;
  state.follow(empty, desktop_time(0s));
  EXPECT_EQ(state.toasts(desktop_time(0s)).size(), 1U);
  state.follow(desktop_room(2), desktop_time(100ms));
  EXPECT_EQ(state.toasts(desktop_time(100ms)).at(0).kind, Toast::Kind::kNotice) << "not due yet";
  state.follow(desktop_room(2), desktop_time(250ms));
  EXPECT_EQ(state.toasts(desktop_time(250ms)).at(0).kind, Toast::Kind::kGood);
}

TEST(DesktopState, panel_has_the_size_and_time_of_the_newest_picture) {
  DesktopState state = state_at_default_start();
  EXPECT_EQ(state.facts(desktop_time(0s)).size, PictureSize());
  draw_and_show(state, desktop_time(0s), 7ms);
  EXPECT_EQ(state.facts(desktop_time(0s)).size, kDesktopWindow);
  EXPECT_DOUBLE_EQ(state.facts(desktop_time(0s)).drawing_ms, 7);
  state.drawn({desktop_time(0s), std::nullopt, 9ms, kEye});
  EXPECT_EQ(state.facts(desktop_time(0s)).size, kEye);
  EXPECT_TRUE(state.facts(desktop_time(0s)).is_worn);
  draw_and_show(state, desktop_time(0s));
  EXPECT_EQ(state.facts(desktop_time(0s)).size, kDesktopWindow) << "taken off";
  EXPECT_FALSE(state.facts(desktop_time(0s)).is_worn);
}

}  // namespace
}  // namespace roomcast::viewer
