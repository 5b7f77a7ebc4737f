// SPDX-License-Identifier: Apache-2.0
// What `roomcast doctor` finds about drawing and watching: graphics, a display, a headset's
// runtime, a browser. Thread-safe (no state), except that check_graphics() leaves no context
// current.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/doctor/finding.h"

namespace roomcast::doctor {

/// `driver`: EglContext::driver_name().
[[nodiscard]] Finding judge_graphics(const std::string& driver);
[[nodiscard]] Finding check_graphics();

/// Values of the environment's variables; empty: not set.
[[nodiscard]] Finding judge_display(std::string_view wayland_display, std::string_view x_display);
[[nodiscard]] Finding check_display();

/// Where OpenXR's loader looks for a runtime (OpenXR loader specification 1.0, "Runtime
/// discovery"), in its order. Empty strings: the variable is not set.
[[nodiscard]] std::vector<std::filesystem::path> openxr_runtime_files(
    const std::string& xr_runtime_json, const std::string& xdg_config_home,
    const std::string& home);
[[nodiscard]] Finding check_headset();

/// The first of the known browsers in one of these folders, which are separated by colons.
[[nodiscard]] std::optional<std::filesystem::path> find_browser(std::string_view path_variable);
[[nodiscard]] Finding check_browser();

}  // namespace roomcast::doctor
