// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include <gtest/gtest.h>

#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/viewer/view/wall_room_fixture.h"
#include "roomcast/viewer/xr/eye_picture.h"
#include "roomcast/viewer/xr/headset_view.h"
#include "roomcast/viewer/xr/test_runtime/test_runtime.h"

namespace roomcast::viewer::xr {
namespace {

client::RoomSnapshot grey_room() {
  return room_with_wall(world_from_optical_looking_at({5, 1.6, 0}, {5, 1.6, -1}),
                        ColorImage(96, 96, {200, 200, 200}));
}

class HeadsetViewTest : public render::GlTest {
 protected:
  void SetUp() override {
    render::GlTest::SetUp();
    ::setenv("XR_RUNTIME_JSON", ROOMCAST_TEST_OPENXR, 1);
    ::setenv("XR_LOADER_DEBUG", "none", 1);
    runtime.reset();
    auto made = RoomView::create();
    ASSERT_TRUE(made.ok()) << made.error().message;
    room.emplace(std::move(*made));
    ASSERT_TRUE(room->show(grey_room()).ok());
    settings.mode = render::RenderMode::kMesh;
    open();
  }
  void open() {
    auto opened = HeadsetView::open();
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    view = std::move(*opened);
    ASSERT_TRUE(view->poll().ok());
  }
  void TearDown() override {
    view.reset();
    for (const std::string& what : runtime.violations) ADD_FAILURE() << what;
    room.reset();
    render::GlTest::TearDown();
  }
  void draw() {
    const Status drawn = view->draw(*room, settings, start, sentences);
    ASSERT_TRUE(drawn.ok()) << drawn.error().message;
  }

  TestRuntime& runtime = TestRuntime::instance();
  std::optional<RoomView> room;
  std::unique_ptr<HeadsetView> view;
  ViewSettings settings;
  std::vector<Toast> sentences;
  const ViewState start = look_from({5, 1.2, 0}, {5, 1.2, -2});
};

TEST_F(HeadsetViewTest, begins_at_the_start_at_the_wearers_height) {
  draw();
  EXPECT_LT((view->pose().world_from_head.translation_m - Eigen::Vector3d(5, 1.6, 0)).norm(), 1e-6);
  EXPECT_EQ(runtime.frames_with_layer, 1U);
  const ColorImage& left = runtime.given[0].color;
  EXPECT_EQ(left.at(left.width() / 2, left.height() / 2), (Rgb8{200, 200, 200})) << "the wall";
}

TEST_F(HeadsetViewTest, hands_are_sent_and_drawn) {
  draw();
  ASSERT_TRUE(view->pose().world_from_left_hand);
  EXPECT_LT(
      (view->pose().world_from_left_hand->translation_m - Eigen::Vector3d(4.8, 1.2, -0.4)).norm(),
      1e-6);
  const ColorImage with_hands = runtime.given[0].color;
  runtime.hands.is_tracked = {false, false};
  draw();
  EXPECT_FALSE(view->pose().world_from_left_hand);
  EXPECT_NE(runtime.given[0].color, with_hands);
}

TEST_F(HeadsetViewTest, the_trigger_points_at_the_wall) {
  runtime.hands.buttons["point right"] = true;
  draw();
  ASSERT_TRUE(view->pose().pointer);
  EXPECT_NEAR(view->pose().pointer->to_m.z(), -2, 0.01);
  EXPECT_NEAR(view->pose().pointer->to_m.x(), 5.2, 0.01);
  runtime.hands.buttons["point right"] = false;
  draw();
  EXPECT_FALSE(view->pose().pointer);
}

TEST_F(HeadsetViewTest, a_push_turns_and_recentring_undoes_it) {
  draw();
  const Eigen::Matrix3d straight = view->pose().world_from_head.rotation;
  runtime.hands.sticks["turn"] = {1, 0};
  draw();
  EXPECT_FALSE(view->pose().world_from_head.rotation.isApprox(straight, 0.1));
  runtime.hands.sticks["turn"] = {0, 0};
  runtime.hands.buttons["recenter"] = true;
  draw();
  EXPECT_TRUE(view->pose().world_from_head.rotation.isApprox(straight, 1e-6));
}

TEST_F(HeadsetViewTest, the_wearer_stays_where_they_are_when_the_stage_moves) {
  draw();
  const RigidTransform before = view->pose().world_from_head;
  const XrPosef moved = {{0, 0.6F, 0, 0.8F}, {1, 0.2F, -2}};  // the new stage in the old one
  const XrTime when = TestRuntime::kBegin_ns + 3 * TestRuntime::kPeriod_ns;
  const RigidTransform new_from_old = transform_from_pose(moved).inverse();
  runtime.head_at = [=](XrTime time) {
    const XrPosef head = {{0, 0, 0, 1}, {0, 1.6F, 0}};
    return time < when ? head : pose_from_transform(new_from_old * transform_from_pose(head));
  };
  runtime.move_space(XR_REFERENCE_SPACE_TYPE_STAGE, when, moved);
  runtime.move_space(XR_REFERENCE_SPACE_TYPE_LOCAL, when, moved);  // not used here
  ASSERT_TRUE(view->poll().ok());
  for (int i = 0; i < 4; ++i) {
    draw();
    const RigidTransform after = view->pose().world_from_head;
    EXPECT_TRUE(after.rotation.isApprox(before.rotation, 1e-5)) << i;
    Eigen::Vector3d step_m = after.translation_m - before.translation_m;
    step_m.y() = 0;  // the floor was measured anew
    EXPECT_LT(step_m.norm(), 1e-5) << i;
  }
}

TEST_F(HeadsetViewTest, a_stage_that_moves_by_an_unknown_step_brings_the_wearer_to_the_start) {
  draw();
  runtime.head_at = [](XrTime) { return XrPosef{{0, 0.6F, 0, 0.8F}, {1, 1.6F, -2}}; };
  runtime.move_space(XR_REFERENCE_SPACE_TYPE_STAGE, TestRuntime::kBegin_ns, std::nullopt);
  ASSERT_TRUE(view->poll().ok());
  draw();
  EXPECT_LT((view->pose().world_from_head.translation_m - Eigen::Vector3d(5, 1.6, 0)).norm(), 1e-5);
  EXPECT_LT((view->pose().world_from_head.rotation - Eigen::Matrix3d::Identity()).norm(), 1e-5);
}

TEST_F(HeadsetViewTest, the_wearers_own_room_is_seen_around_the_surfaces_where_displays_can) {
  settings.comfort.sees_through = true;
  draw();
  EXPECT_EQ(runtime.blend_mode, XR_ENVIRONMENT_BLEND_MODE_OPAQUE) << "they cannot";
  EXPECT_TRUE(runtime.given[0].alpha.empty());
  view.reset();
  runtime.blend_modes.push_back(XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND);
  open();
  ASSERT_TRUE(view->may_see_through());
  render::RenderOptions clear;
  clear.background_is_clear = true;
  clear.floor_grid = false;
  ASSERT_TRUE(room->set_options(clear).ok());
  for (const auto mode : render::kRenderModes) {
    settings.mode = mode;
    draw();
    EXPECT_EQ(runtime.blend_mode, XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND);
    const GivenEye& eye = runtime.given[0];
    const int x = eye.color.width() / 2, y = eye.color.height() / 2;
    EXPECT_EQ(eye.alpha.at(x, y), 255) << "the wall, " << name_of(mode);
    EXPECT_EQ(eye.alpha.at(1, 1), 0) << "beside it, " << name_of(mode);
    EXPECT_EQ(eye.color.at(1, 1), Rgb8{});
  }
  settings.comfort.sees_through = false;
  draw();
  EXPECT_EQ(runtime.blend_mode, XR_ENVIRONMENT_BLEND_MODE_OPAQUE);
}

TEST_F(HeadsetViewTest, the_left_trigger_points_from_the_left_hand) {
  runtime.hands.buttons["point left"] = true;
  draw();
  ASSERT_TRUE(view->pose().pointer);
  EXPECT_NEAR(view->pose().pointer->to_m.x(), 4.8, 0.01);
}

TEST_F(HeadsetViewTest, sentences_are_before_the_eyes_until_they_are_no_longer_true) {
  draw();
  EXPECT_FALSE(runtime.given_board);
  sentences = {{Toast::Kind::kError, "The hub is lost."}};
  draw();
  ASSERT_TRUE(runtime.given_board);
  const GivenBoard one = *runtime.given_board;
  EXPECT_TRUE(one.goes_with_head);
  EXPECT_LT(one.pose.position.z, -1);
  EXPECT_LT(one.pose.position.y, 0) << "below the line of sight";
  EXPECT_NEAR(one.size.width / one.size.height,
              static_cast<double>(one.color.width()) / one.color.height(), 1e-3);
  EXPECT_EQ(one.color.at(2, 2), TextPicture::kGround);
  int red = 0;
  for (int y = 0; y < one.color.height(); ++y) {
    for (int x = 0; x < one.color.width(); ++x) red += one.color.at(x, y).r > 200 ? 1 : 0;
  }
  EXPECT_GT(red, 500) << "letters";
  draw();
  EXPECT_EQ(runtime.given_board->color, one.color) << "it stays";
  sentences.push_back({Toast::Kind::kNotice, "Sensor left is gone."});
  draw();
  EXPECT_GT(runtime.given_board->color.height(), one.color.height());
  sentences.clear();
  draw();
  EXPECT_FALSE(runtime.given_board);
}

TEST_F(HeadsetViewTest, reports_its_timing) {
  draw();
  EXPECT_NE(view->report().find("test headset (roomcast test runtime): 90 Hz"), std::string::npos)
      << view->report();
  runtime.take_off();
  ASSERT_TRUE(view->poll().ok());
  EXPECT_NE(view->report().find("not worn"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::viewer::xr
