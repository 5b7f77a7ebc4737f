// SPDX-License-Identifier: Apache-2.0
// Tests controllers and hands with the test runtime.
#include "roomcast/viewer/xr/headset_fixture.h"

namespace roomcast::viewer::xr {
namespace {

class ActionsTest : public HeadsetTest {};

TEST_F(ActionsTest, hands_have_their_poses_and_buttons) {
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

TEST_F(ActionsTest, a_trackpad_counts_only_while_it_is_pressed) {
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

TEST_F(ActionsTest, suggests_bindings_for_the_controllers_that_the_runtime_knows) {
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

}  // namespace
}  // namespace roomcast::viewer::xr
