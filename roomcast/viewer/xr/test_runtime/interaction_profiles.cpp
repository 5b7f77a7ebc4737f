// SPDX-License-Identifier: Apache-2.0
// TestRuntime: the controllers that real runtimes know, and their parts that a client may bind
// (OpenXR 1.0, section 6.4, and the extensions named here).
#include <array>
#include <string_view>

#include "roomcast/viewer/xr/test_runtime/session_record.h"
#include "roomcast/viewer/xr/test_runtime/test_runtime.h"

namespace roomcast::viewer::xr {
namespace {

/// Parts separated by spaces; both hands also have the poses.
struct KnownController {
  std::string_view profile, extension, both, left, right;
};

constexpr std::string_view kTouchBoth =
    "squeeze/value trigger/value trigger/touch thumbstick thumbstick/click thumbstick/touch";
constexpr std::string_view kClicksBoth =
    "squeeze/click squeeze/value trigger/click trigger/value thumbstick thumbstick/click "
    "thumbstick/touch";
constexpr std::string_view kX = "x/click y/click menu/click", kA = "a/click b/click system/click";

constexpr std::array kKnown = {
    KnownController{"khr/simple_controller", "", "select/click menu/click", "", ""},
    KnownController{"oculus/touch_controller", "", kTouchBoth, kX, kA},
    KnownController{"valve/index_controller", "",
                    "a/click b/click squeeze/value squeeze/force trigger/click trigger/value "
                    "trigger/touch thumbstick thumbstick/click thumbstick/touch trackpad "
                    "trackpad/force trackpad/touch system/click",
                    "", ""},
    KnownController{"microsoft/motion_controller", "",
                    "menu/click squeeze/click trigger/value thumbstick thumbstick/click trackpad "
                    "trackpad/click trackpad/touch",
                    "", ""},
    KnownController{"htc/vive_controller", "",
                    "system/click squeeze/click menu/click trigger/click trigger/value trackpad "
                    "trackpad/click trackpad/touch",
                    "", ""},
    KnownController{"hp/mixed_reality_controller", "XR_EXT_hp_mixed_reality_controller",
                    "menu/click squeeze/value trigger/value thumbstick thumbstick/click",
                    "x/click y/click", "a/click b/click"},
    KnownController{"facebook/touch_controller_pro", "XR_FB_touch_controller_pro", kTouchBoth, kX,
                    kA},
    KnownController{"meta/touch_controller_plus", "XR_META_touch_controller_plus", kTouchBoth, kX,
                    kA},
    KnownController{"bytedance/pico_neo3_controller", "XR_BD_controller_interaction", kClicksBoth,
                    kX, kA},
    KnownController{"bytedance/pico4_controller", "XR_BD_controller_interaction", kClicksBoth, kX,
                    kA},
    KnownController{"htc/vive_focus3_controller", "XR_HTC_vive_focus3_controller_interaction",
                    kClicksBoth, kX, kA},
    KnownController{"htc/vive_cosmos_controller", "XR_HTC_vive_cosmos_controller_interaction",
                    "shoulder/click squeeze/click trigger/click trigger/value thumbstick "
                    "thumbstick/click thumbstick/touch",
                    kX, kA},
    KnownController{"ext/hand_interaction_ext", "XR_EXT_hand_interaction",
                    "pinch_ext/pose pinch_ext/value pinch_ext/ready_ext poke_ext/pose "
                    "aim_activate_ext/value aim_activate_ext/ready_ext grasp_ext/value "
                    "grasp_ext/ready_ext",
                    "", ""},
    KnownController{"microsoft/hand_interaction", "XR_MSFT_hand_interaction",
                    "select/value squeeze/value", "", ""},
};

bool is_among(std::string_view parts, const std::string& part) {
  return (" " + std::string(parts) + " ").find(" " + part + " ") != std::string::npos;
}

}  // namespace

bool has_part(const std::string& profile, const std::string& part) {
  constexpr std::string_view kProfiles = "/interaction_profiles/", kHands = "/user/hand/";
  const bool is_left = part.find("/left/input/") == kHands.size() - 1;
  const auto begin = part.find("/input/");
  if (profile.rfind(kProfiles, 0) != 0 || begin == std::string::npos) return false;
  const std::string name = part.substr(begin + std::string_view("/input/").size());
  for (const KnownController& known : kKnown) {
    if (profile.substr(kProfiles.size()) != known.profile) continue;
    const auto& extensions = TestRuntime::instance().extensions;
    if (!known.extension.empty() && !extensions.contains(std::string(known.extension)))
      return false;
    return is_among("grip/pose aim/pose", name) || is_among(known.both, name) ||
           is_among(is_left ? known.left : known.right, name);
  }
  return false;
}

}  // namespace roomcast::viewer::xr
