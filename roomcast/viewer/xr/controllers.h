// SPDX-License-Identifier: Apache-2.0
// The controllers, and hands without one, whose parts the viewer suggests for its actions. Those
// behind an extension are suggested where the runtime offers it; other runtimes map controllers
// that they do not know to one that they do. Source: OpenXR 1.0, section 6.4 (interaction
// profiles), and the extensions named here.
#pragma once

#include <array>

namespace roomcast::viewer::xr {

/// Parts are below /user/hand/left/input/ and /user/hand/right/input/. Null: there is none.
struct Controller {
  const char* extension;  // null: OpenXR 1.0 itself
  const char* profile;    // below /interaction_profiles/
  const char* stick;      // of the left hand for walking, of the right one for turning
  const char* press;      // must be held for the stick to count: a trackpad is touched by chance
  const char* point;      // of each hand
  const char* select;     // of each hand, where there is only one button
  const char* recenter;   // of the left hand
};

inline constexpr std::array kControllers = {
    Controller{nullptr, "khr/simple_controller", nullptr, nullptr, nullptr, "select/click",
               "menu/click"},
    Controller{nullptr, "oculus/touch_controller", "thumbstick", nullptr, "trigger/value", nullptr,
               "y/click"},
    Controller{nullptr, "valve/index_controller", "thumbstick", nullptr, "trigger/click", nullptr,
               "b/click"},
    Controller{nullptr, "microsoft/motion_controller", "thumbstick", nullptr, "trigger/value",
               nullptr, "menu/click"},
    Controller{nullptr, "htc/vive_controller", "trackpad", "trackpad/click", "trigger/click",
               nullptr, "menu/click"},
    Controller{"XR_EXT_hp_mixed_reality_controller", "hp/mixed_reality_controller", "thumbstick",
               nullptr, "trigger/value", nullptr, "y/click"},
    Controller{"XR_FB_touch_controller_pro", "facebook/touch_controller_pro", "thumbstick", nullptr,
               "trigger/value", nullptr, "y/click"},
    Controller{"XR_META_touch_controller_plus", "meta/touch_controller_plus", "thumbstick", nullptr,
               "trigger/value", nullptr, "y/click"},
    Controller{"XR_BD_controller_interaction", "bytedance/pico_neo3_controller", "thumbstick",
               nullptr, "trigger/value", nullptr, "y/click"},
    Controller{"XR_BD_controller_interaction", "bytedance/pico4_controller", "thumbstick", nullptr,
               "trigger/value", nullptr, "y/click"},
    Controller{"XR_HTC_vive_focus3_controller_interaction", "htc/vive_focus3_controller",
               "thumbstick", nullptr, "trigger/value", nullptr, "y/click"},
    Controller{"XR_HTC_vive_cosmos_controller_interaction", "htc/vive_cosmos_controller",
               "thumbstick", nullptr, "trigger/value", nullptr, "y/click"},
    Controller{"XR_EXT_hand_interaction", "ext/hand_interaction_ext", nullptr, nullptr, nullptr,
               "pinch_ext/value", nullptr},
    Controller{"XR_MSFT_hand_interaction", "microsoft/hand_interaction", nullptr, nullptr, nullptr,
               "select/value", nullptr},
};

}  // namespace roomcast::viewer::xr
