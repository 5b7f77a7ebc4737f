// SPDX-License-Identifier: Apache-2.0
// Tests a session with the test runtime: its pictures, its states, and the rules of OpenXR.
#include <filesystem>
#include <fstream>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/viewer/window/view_window.h"
#include "roomcast/viewer/xr/headset_fixture.h"
#include "roomcast/viewer/xr/x_server.h"

namespace roomcast::viewer::xr {
namespace {

/// Renders without a headset, for the pose and angles of `eye`.
ColorImage mono_picture(RoomView& room, const GivenEye& eye) {
  const double left = std::tan(-eye.fov.angleLeft), right = std::tan(eye.fov.angleRight);
  const double down = std::tan(-eye.fov.angleDown), up = std::tan(eye.fov.angleUp);
  const double focal = eye.color.width() / (left + right);
  const auto pixels = [focal](double tangent) {
    return static_cast<int>(std::lround(focal * tangent));
  };
  render::ViewCamera camera;
  camera.width = 2 * pixels(std::max(left, right));
  camera.height = 2 * pixels(std::max(up, down));
  camera.vertical_fov_rad = 2 * std::atan(0.5 * camera.height / focal);
  camera.world_from_view = transform_from_pose(eye.pose);
  RoomPicture picture;
  EXPECT_TRUE(picture.draw(room, camera, render::RenderMode::kMesh).ok());
  const ColorImage whole = picture.target()->read_color();
  ColorImage part(eye.color.width(), eye.color.height());
  const int x0 = camera.width / 2 - pixels(left), y0 = camera.height / 2 - pixels(up);
  for (int y = 0; y < part.height(); ++y) {
    for (int x = 0; x < part.width(); ++x) part.at(x, y) = whole.at(x0 + x, y0 + y);
  }
  return part;
}

double share_of_other_pixels(const ColorImage& a, const ColorImage& b) {
  int others = 0;
  for (std::size_t i = 0; i < a.view().pixel_count(); ++i)
    others += a.data()[i] == b.data()[i] ? 0 : 1;
  return static_cast<double>(others) / static_cast<double>(a.view().pixel_count());
}

TEST_F(HeadsetTest, both_eyes_see_what_the_renderer_draws_without_a_headset) {
  open();
  EXPECT_TRUE(runtime.uses_egl);
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(draw().ok());
    for (const GivenEye& eye : runtime.given) {
      ASSERT_LE(eye.color.width(), TestRuntime::kEyeWidth);
      EXPECT_LT(share_of_other_pixels(eye.color, mono_picture(*room, eye)), 1e-3);
    }
  }
  EXPECT_EQ(runtime.frames_with_layer, 5U);
}

TEST_F(HeadsetTest, each_eye_sees_from_its_own_side) {
  open();
  ASSERT_TRUE(draw().ok());
  const auto& [left, right] = runtime.given;
  const Eigen::Vector3d apart =
      transform_from_pose(right.pose).translation_m - transform_from_pose(left.pose).translation_m;
  EXPECT_NEAR(apart.norm(), 2 * TestRuntime::kHalfEyeDistance_m, 1e-6);
  EXPECT_GT(share_of_other_pixels(left.color, right.color), 0.01);
}

TEST_F(HeadsetTest, the_pictures_depth_is_submitted_with_it) {
  runtime.head_at = [](XrTime) { return XrPosef{{0, 0, 0, 1}, {0, 1.6F, 0}}; };
  open();
  ASSERT_TRUE(draw().ok());
  const GivenEye& eye = runtime.given[0];
  ASSERT_EQ(eye.depth.width(), eye.color.width());
  const double ndc = 2 * eye.depth.at(eye.depth.width() / 2, eye.depth.height() / 2) - 1.0;
  const double near = eye.near_m, far = eye.far_m;
  EXPECT_NEAR(2 * far * near / (far + near - ndc * (far - near)), 2, 0.01);
}

TEST_F(HeadsetTest, a_runtime_without_depth_layers_gets_no_depth) {
  runtime.offers_depth = false;
  open();
  ASSERT_TRUE(draw().ok());
  EXPECT_TRUE(runtime.given[0].depth.empty());
  EXPECT_FALSE(runtime.given[0].color.empty());
}

TEST_F(HeadsetTest, an_image_that_comes_late_costs_one_frame) {
  open();
  for (const std::size_t late : {0U, 1U, 2U, 3U}) {  // colour and depth of each eye
    const auto before = runtime.frames_with_layer;
    runtime.image_waits.assign(late, XR_SUCCESS);
    runtime.image_waits.push_back(XR_TIMEOUT_EXPIRED);
    const Status skipped = draw();
    EXPECT_TRUE(skipped.ok()) << skipped.error().message;
    EXPECT_EQ(runtime.frames_with_layer, before);
    ASSERT_TRUE(draw().ok());
    EXPECT_EQ(runtime.frames_with_layer, before + 1);
    EXPECT_EQ(runtime.acquired_images, 0);
    EXPECT_LT(share_of_other_pixels(runtime.given[1].color, mono_picture(*room, runtime.given[1])),
              1e-3);
  }
}

TEST_F(HeadsetTest, can_go_on_after_a_wait_for_depth_that_failed) {
  open();
  runtime.image_waits = {XR_SUCCESS, XR_ERROR_RUNTIME_FAILURE};
  EXPECT_FALSE(draw().ok());
  ASSERT_TRUE(draw().ok());
  EXPECT_EQ(runtime.frames_with_layer, 1U);
  EXPECT_EQ(runtime.acquired_images, 0);
}

TEST_F(HeadsetTest, wants_no_frames_while_it_is_taken_off_and_goes_on_afterwards) {
  open();
  ASSERT_TRUE(draw().ok());
  runtime.take_off();
  ASSERT_TRUE(headset->poll().ok());
  EXPECT_FALSE(headset->is_running());
  runtime.put_on();
  ASSERT_TRUE(headset->poll().ok());
  EXPECT_TRUE(headset->is_running());
  ASSERT_TRUE(draw().ok());
  EXPECT_EQ(runtime.frames_with_layer, 2U);
}

TEST_F(HeadsetTest, reports_when_the_wearer_ends_the_session) {
  open();
  ASSERT_TRUE(draw().ok());
  runtime.ask_for_end();
  const Status over = headset->poll();
  ASSERT_FALSE(over.ok());
  EXPECT_EQ(over.error().code, ErrorCode::kClosed);
  EXPECT_EQ(over.error().message, "the headset was put away");
  EXPECT_TRUE(headset->has_exited());
}

TEST_F(HeadsetTest, ends_in_good_order_when_asked) {
  open();
  ASSERT_TRUE(draw().ok());
  ASSERT_TRUE(headset->request_exit().ok());
  EXPECT_FALSE(headset->poll().ok());
  EXPECT_FALSE(headset->is_running());
}

TEST_F(HeadsetTest, that_is_lost_can_be_found_again) {
  open();
  ASSERT_TRUE(draw().ok());
  runtime.lose_session();
  const Status lost = draw();
  ASSERT_FALSE(lost.ok());
  EXPECT_EQ(lost.error().code, ErrorCode::kClosed);
  EXPECT_FALSE(headset->poll().ok());
  EXPECT_FALSE(headset->has_exited());
  headset.reset();
  open();
  EXPECT_TRUE(draw().ok());
}

TEST_F(HeadsetTest, a_head_that_is_not_tracked_sees_nothing) {
  runtime.is_tracked = false;
  open();
  ASSERT_TRUE(draw().ok());
  EXPECT_EQ(runtime.frames, 1U);
  EXPECT_EQ(runtime.frames_with_layer, 0U);
}

TEST_F(HeadsetTest, with_canted_displays_the_head_looks_between_them) {
  constexpr float kHalfYaw_rad = 0.2F;
  runtime.cant_rad = 0.17F;
  runtime.head_at = [](XrTime) {
    return XrPosef{{0, std::sin(kHalfYaw_rad), 0, std::cos(kHalfYaw_rad)}, {0.3F, 1.6F, 0}};
  };
  open();
  const auto frame = headset->begin_frame();
  ASSERT_TRUE(frame.ok());
  const RigidTransform expected = transform_from_pose(runtime.head_at(0));
  EXPECT_TRUE(frame->input.stage_from_head.rotation.isApprox(expected.rotation, 1e-5));
  EXPECT_TRUE(frame->input.stage_from_head.translation_m.isApprox(expected.translation_m, 1e-5));
  EXPECT_FALSE(headset->end_frame().ok()) << "its eyes were given nothing";
}

TEST_F(HeadsetTest, a_frame_behind_another_program_is_not_seen) {
  runtime.is_seen = false;
  open();
  ASSERT_TRUE(draw().ok());
  EXPECT_EQ(runtime.frames, 1U);
  EXPECT_EQ(runtime.frames_with_layer, 0U);
  EXPECT_TRUE(headset->is_running());
}

TEST_F(HeadsetTest, its_frames_are_timed) {
  open();
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(draw().ok());
  EXPECT_EQ(headset->timing().frames(), 3U);
  EXPECT_EQ(headset->timing().missed(), 0U);
  EXPECT_NEAR(headset->timing().headset_per_s(), 90, 0.1);
  EXPECT_GT(headset->timing().ours().count(), 0);
}

// Runs with Khronos's validation layer, which does not support EGL contexts; so this context is
// GLX's.
TEST(HeadsetOnX11, keeps_the_rules_that_khronos_checks) {
  const char* const layer =
      "/usr/share/openxr/1/api_layers/explicit.d/"
      "XrApiLayer_core_validation.x86_64-linux-gnu.json";
  if (!std::filesystem::exists(layer))
    GTEST_SKIP() << "Khronos' core validation is not installed (openxr-layer-corevalidation)";
  const auto server = XServer::start();
  if (!server) GTEST_SKIP() << "there is no X server to be had (xvfb)";
  use_test_runtime();
  TestRuntime::instance().head_at = nodding_head;
  const TemporaryFolder folder;
  const auto log = folder / "complaints.txt";
  ::setenv("XR_ENABLE_API_LAYERS", "XR_APILAYER_LUNARG_core_validation", 1);
  ::setenv("XR_CORE_VALIDATION_EXPORT_TYPE", "text", 1);
  ::setenv("XR_CORE_VALIDATION_FILE_NAME", log.c_str(), 1);
  ::setenv("DISPLAY", server->display().c_str(), 1);
  ::setenv("SDL_VIDEODRIVER", "x11", 1);
  {
    auto window = ViewWindow::open({});
    ASSERT_TRUE(window.ok()) << window.error().message;
    auto room = RoomView::create();
    ASSERT_TRUE(room.ok()) << room.error().message;
    ASSERT_TRUE(room->show(two_colored_room()).ok());
    RoomPicture picture;
    auto headset = Headset::open();
    ASSERT_TRUE(headset.ok()) << headset.error().message;
    EXPECT_FALSE(TestRuntime::instance().uses_egl);
    ASSERT_TRUE((*headset)->poll().ok());
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(draw_frame(**headset, *room, picture).ok());
    ASSERT_TRUE((*headset)->tell({{Toast::Kind::kError, "The hub is lost."}}).ok());
    ASSERT_TRUE(draw_frame(**headset, *room, picture).ok());
    EXPECT_TRUE(TestRuntime::instance().given_board);
    EXPECT_TRUE((*headset)->request_exit().ok());
    EXPECT_FALSE((*headset)->poll().ok());
  }
  ::unsetenv("XR_ENABLE_API_LAYERS");
  EXPECT_TRUE(TestRuntime::instance().violations.empty());
  std::ifstream written(log);
  const std::string complaints(std::istreambuf_iterator<char>(written), {});
  EXPECT_EQ(complaints, "");
}

}  // namespace
}  // namespace roomcast::viewer::xr
