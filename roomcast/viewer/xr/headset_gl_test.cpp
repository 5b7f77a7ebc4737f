// SPDX-License-Identifier: Apache-2.0
// Tests a session with the test runtime through the system's OpenXR loader.
#include <cmath>
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/render/surface/sensor_pictures_fixture.h"
#include "roomcast/viewer/view/room_picture.h"
#include "roomcast/viewer/view/wall_room_fixture.h"
#include "roomcast/viewer/window/view_window.h"
#include "roomcast/viewer/xr/headset.h"
#include "roomcast/viewer/xr/test_runtime/test_runtime.h"
#include "roomcast/viewer/xr/x_server.h"

namespace roomcast::viewer::xr {
namespace {

/// A wall 2 m ahead with a red left half, a green right half, and a black border below.
client::RoomSnapshot two_colored_room() {
  constexpr int kSide = 96;
  ColorImage color(kSide, kSide, {200, 10, 10});
  render::fill_box<Rgb8>(color, kSide / 2, 0, kSide, kSide, {10, 190, 10});
  return room_with_wall(world_from_optical_looking_at({0, 1.6, 0}, {0, 1.6, -1}), color);
}

void use_test_runtime() {
  ::setenv("XR_RUNTIME_JSON", ROOMCAST_TEST_OPENXR, 1);
  ::setenv("XR_LOADER_DEBUG", "none", 1);
  ::unsetenv("XR_ENABLE_API_LAYERS");
  TestRuntime::instance().reset();
}

/// A reproducible motion of the head.
XrPosef nodding_head(XrTime time) {
  const double seconds = 1e-9 * static_cast<double>(time - TestRuntime::kBegin_ns);
  const auto half_yaw = static_cast<float>(0.15 * std::sin(9 * seconds));
  return {{0, std::sin(half_yaw), 0, std::cos(half_yaw)},
          {static_cast<float>(0.1 * std::sin(7 * seconds)), 1.62F, 0.05F}};
}

Status draw_frame(Headset& headset, RoomView& room, RoomPicture& picture) {
  const auto frame = headset.begin_frame();
  if (!frame) return frame.error();
  if (frame->is_seen) {
    if (auto status = picture.draw(room, headset.stage_eyes(), render::RenderMode::kMesh); !status)
      return status;
    headset.show(*picture.target());
  }
  return headset.end_frame();
}

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

class HeadsetTest : public render::GlTest {
 protected:
  void SetUp() override {
    render::GlTest::SetUp();
    use_test_runtime();
    runtime.head_at = nodding_head;
    auto made = RoomView::create();
    ASSERT_TRUE(made.ok()) << made.error().message;
    room.emplace(std::move(*made));
    ASSERT_TRUE(room->show(two_colored_room()).ok());
    picture.emplace();
  }
  void TearDown() override {
    headset.reset();
    EXPECT_EQ(runtime.open_handles, 0);
    for (const std::string& what : runtime.violations) ADD_FAILURE() << what;
    picture.reset();
    room.reset();
    render::GlTest::TearDown();
  }

  void open() {
    auto opened = Headset::open();
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    headset = std::move(*opened);
    ASSERT_TRUE(headset->poll().ok());
    ASSERT_TRUE(headset->is_running());
  }
  Status draw() { return draw_frame(*headset, *room, *picture); }

  TestRuntime& runtime = TestRuntime::instance();
  std::optional<RoomView> room;
  std::optional<RoomPicture> picture;
  std::unique_ptr<Headset> headset;
};

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

TEST_F(HeadsetTest, hands_have_their_poses_and_buttons) {
  open();
  runtime.hands.sticks["walk"] = {0.5F, 1};
  runtime.hands.buttons["point right"] = true;
  runtime.hands.buttons["recenter"] = true;
  runtime.hands.is_tracked = {false, true};
  const auto first = headset->begin_frame();
  ASSERT_TRUE(first.ok());
  EXPECT_EQ(first->input.left.stick, Eigen::Vector2d(0.5, 1));
  EXPECT_TRUE(first->input.right.points);
  EXPECT_FALSE(first->input.left.points);
  EXPECT_TRUE(first->input.recenters);
  EXPECT_FALSE(first->input.left.stage_from_grip);
  ASSERT_TRUE(first->input.right.stage_from_grip);
  EXPECT_NEAR(first->input.right.stage_from_grip->translation_m.y(), 1.2, 1e-6);
  EXPECT_NEAR(first->input.stage_from_head.translation_m.y(), 1.62, 1e-6);
  EXPECT_FALSE(headset->end_frame().ok()) << "its eyes were given nothing";
  const auto second = headset->begin_frame();
  ASSERT_TRUE(second.ok());
  EXPECT_FALSE(second->input.recenters) << "once for each press";
  EXPECT_FALSE(headset->end_frame().ok());
}

TEST_F(HeadsetTest, a_trackpad_counts_only_while_it_is_pressed) {
  open();
  runtime.hands.sticks["walk"] = {0, 1};
  runtime.hands.buttons["press left"] = false;
  const auto touched = headset->begin_frame();
  ASSERT_TRUE(touched.ok());
  EXPECT_EQ(touched->input.left.stick, Eigen::Vector2d(0, 0));
  EXPECT_FALSE(headset->end_frame().ok());
  runtime.hands.buttons["press left"] = true;
  const auto pressed = headset->begin_frame();
  ASSERT_TRUE(pressed.ok());
  EXPECT_EQ(pressed->input.left.stick, Eigen::Vector2d(0, 1));
  EXPECT_FALSE(headset->end_frame().ok());
}

TEST_F(HeadsetTest, suggests_bindings_for_the_controllers_that_the_runtime_knows) {
  open();
  EXPECT_EQ(runtime.bindings.size(), 5U) << "those of OpenXR 1.0";
  headset.reset();
  runtime.reset();
  runtime.head_at = nodding_head;
  runtime.more_extensions = {"XR_EXT_hp_mixed_reality_controller",
                             "XR_FB_touch_controller_pro",
                             "XR_META_touch_controller_plus",
                             "XR_BD_controller_interaction",
                             "XR_HTC_vive_focus3_controller_interaction",
                             "XR_HTC_vive_cosmos_controller_interaction",
                             "XR_EXT_hand_interaction",
                             "XR_MSFT_hand_interaction",
                             "XR_EXT_something_else"};
  open();
  EXPECT_EQ(runtime.bindings.size(), 14U);
  EXPECT_FALSE(runtime.extensions.contains("XR_EXT_something_else"));
  const auto bound = [this](const std::string& profile, const std::string& part) {
    return runtime.bindings.at("/interaction_profiles/" + profile)[part];
  };
  EXPECT_EQ(bound("bytedance/pico4_controller", "/user/hand/right/input/thumbstick"), "turn");
  EXPECT_EQ(bound("htc/vive_controller", "/user/hand/left/input/trackpad/click"), "press");
  EXPECT_EQ(bound("khr/simple_controller", "/user/hand/right/input/select/click"), "select");
  EXPECT_EQ(bound("ext/hand_interaction_ext", "/user/hand/right/input/pinch_ext/value"), "select");
}

TEST_F(HeadsetTest, stands_on_the_best_floor_that_is_offered) {
  constexpr auto kLocalFloorSpace = static_cast<XrReferenceSpaceType>(1000426000);
  const auto stage_of = [this](std::vector<XrReferenceSpaceType> offered) {
    runtime.spaces = std::move(offered);
    open();
    EXPECT_TRUE(draw().ok());
    headset.reset();
    return runtime.stage;
  };
  constexpr auto kView = XR_REFERENCE_SPACE_TYPE_VIEW, kLocal = XR_REFERENCE_SPACE_TYPE_LOCAL,
                 kStage = XR_REFERENCE_SPACE_TYPE_STAGE;
  runtime.more_extensions = {"XR_EXT_local_floor"};
  EXPECT_EQ(stage_of({kView, kLocal, kLocalFloorSpace, kStage}), kStage);
  EXPECT_EQ(stage_of({kView, kLocal, kLocalFloorSpace}), kLocalFloorSpace);
  EXPECT_EQ(stage_of({kView, kLocal}), kLocal);
}

TEST_F(HeadsetTest, shows_pictures_as_its_displays_can) {
  const auto mode_of = [this](std::vector<XrEnvironmentBlendMode> offered) {
    runtime.blend_modes = std::move(offered);
    open();
    EXPECT_TRUE(draw().ok());
    EXPECT_EQ(headset->adds_light(), runtime.blend_mode == XR_ENVIRONMENT_BLEND_MODE_ADDITIVE);
    headset.reset();
    return runtime.blend_mode;
  };
  constexpr auto kOpaque = XR_ENVIRONMENT_BLEND_MODE_OPAQUE,
                 kAdditive = XR_ENVIRONMENT_BLEND_MODE_ADDITIVE,
                 kAlpha = XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND;
  EXPECT_EQ(mode_of({kAlpha, kOpaque}), kOpaque);
  EXPECT_EQ(mode_of({kAdditive}), kAdditive);
  EXPECT_EQ(mode_of({kAlpha, kAdditive}), kAlpha);
}

TEST_F(HeadsetTest, its_frames_are_timed) {
  open();
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(draw().ok());
  EXPECT_EQ(headset->timing().frames(), 3U);
  EXPECT_EQ(headset->timing().missed(), 0U);
  EXPECT_NEAR(headset->timing().headset_per_s(), 90, 0.1);
  EXPECT_GT(headset->timing().ours().count(), 0);
}

TEST_F(HeadsetTest, without_a_headset_the_error_is_a_sentence) {
  runtime.is_connected = false;
  const auto none = Headset::open();
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().message, "no headset is connected: connect it, or wake it up");
}

TEST_F(HeadsetTest, without_its_service_the_error_is_a_sentence) {
  runtime.service_runs = false;
  const auto none = Headset::open();
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().message,
            "the headset's software does not answer: start its service (SteamVR, monado-service, "
            "...), and connect the headset");
}

TEST_F(HeadsetTest, a_wrong_name_of_the_runtime_is_in_the_error) {
  const TemporaryFolder folder;
  const auto missing = folder / "typo.json", malformed = folder / "malformed.json",
             without_library = folder / "without_library.json";
  std::ofstream(malformed) << "{";
  std::ofstream(without_library)
      << R"({"file_format_version": "1.0.0", "runtime": {"library_path": "/nonexistent.so"}})";
  for (const auto& named : {missing, malformed, without_library}) {
    ::setenv("XR_RUNTIME_JSON", named.c_str(), 1);
    const auto none = Headset::open();
    ASSERT_FALSE(none.ok());
    EXPECT_EQ(none.error().message.find("XR_RUNTIME_JSON is \"" + named.string() + "\""), 0U)
        << none.error().message;
  }
}

TEST_F(HeadsetTest, without_a_runtime_the_error_is_a_sentence) {
  ::unsetenv("XR_RUNTIME_JSON");
  const TemporaryFolder empty;
  for (const char* const folders : {"XDG_CONFIG_HOME", "XDG_CONFIG_DIRS", "XDG_DATA_DIRS"})
    ::setenv(folders, empty.path().c_str(), 1);
  const auto none = Headset::open();
  for (const char* const folders : {"XDG_CONFIG_HOME", "XDG_CONFIG_DIRS", "XDG_DATA_DIRS"})
    ::unsetenv(folders);
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().message.find("no headset software runs here"), 0U) << none.error().message;
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
