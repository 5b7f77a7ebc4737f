// SPDX-License-Identifier: Apache-2.0
#include "roomcast/doctor/pictures.h"

#include <array>
#include <cstdlib>
#include <ranges>

#include "roomcast/render/gl/gl_context.h"

namespace roomcast::doctor {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 8> kBrowsers = {
    "google-chrome",  "google-chrome-stable", "chromium", "chromium-browser",
    "microsoft-edge", "brave-browser",        "firefox",  "firefox-esr"};

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

}  // namespace

Finding judge_graphics(const std::string& driver) {
  if (render::is_in_software(driver)) {
    return {
        "graphics", Verdict::kNotice,
        "Windows and films are drawn by the processor (" + driver + "), which is slow.",
        "Install the driver of the graphics card, if there is one. A hub and sensors need none."};
  }
  return {"graphics", Verdict::kOk, "Windows and films are drawn by " + driver + "."};
}

Finding check_graphics() {
  const auto context = render::EglContext::create();
  if (context) return judge_graphics(context->driver_name());
  return {"graphics", Verdict::kProblem,
          "roomcast view and films cannot draw: " + context.error().message,
          "A hub, sensors and the page work without."};
}

Finding judge_display(std::string_view wayland_display, std::string_view x_display) {
  if (!wayland_display.empty())
    return {"display", Verdict::kOk,
            "Windows open on the Wayland display " + std::string(wayland_display) + "."};
  if (!x_display.empty())
    return {"display", Verdict::kOk,
            "Windows open on the X display " + std::string(x_display) + "."};
  return {"display", Verdict::kNotice, "There is no display for windows here.",
          "Open the page in a browser elsewhere, or draw a picture: roomcast view --headless --png "
          "FILE"};
}

Finding check_display() {
  return judge_display(variable("WAYLAND_DISPLAY"), variable("DISPLAY"));
}

std::vector<fs::path> openxr_runtime_files(const std::string& xr_runtime_json,
                                           const std::string& xdg_config_home,
                                           const std::string& home) {
  if (!xr_runtime_json.empty()) return {xr_runtime_json};
  const fs::path file = fs::path("openxr") / "1" / "active_runtime.json";
  std::vector<fs::path> files;
  if (!xdg_config_home.empty()) {
    files.push_back(xdg_config_home / file);
  } else if (!home.empty()) {
    files.push_back(fs::path(home) / ".config" / file);
  }
  files.push_back("/etc/xdg" / file);
  files.push_back("/usr/local/etc" / file);
  files.push_back("/etc" / file);
  return files;
}

Finding check_headset() {
  const auto files = openxr_runtime_files(variable("XR_RUNTIME_JSON"), variable("XDG_CONFIG_HOME"),
                                          variable("HOME"));
  for (const fs::path& file : files) {
    std::error_code error;
    if (fs::is_regular_file(file, error))
      return {"headset", Verdict::kOk, "An OpenXR runtime is installed: " + file.string() + "."};
  }
  return {"headset", Verdict::kNotice, "No OpenXR runtime is installed, so --vr finds no headset.",
          "Install the headset's runtime, for example Monado or SteamVR, or use the headset's own "
          "browser."};
}

std::optional<fs::path> find_browser(std::string_view path_variable) {
  for (const std::string_view browser : kBrowsers) {
    for (const auto part : std::views::split(path_variable, ':')) {
      const fs::path file = fs::path(std::string(part.begin(), part.end())) / browser;
      std::error_code error;
      if (fs::is_regular_file(file, error)) return file;
    }
  }
  return std::nullopt;
}

Finding check_browser() {
  if (const auto browser = find_browser(variable("PATH")))
    return {"browser", Verdict::kOk, "The page can be opened with " + browser->string() + "."};
  return {"browser", Verdict::kNotice, "No browser was found on this computer.",
          "Open the page on another one."};
}

}  // namespace roomcast::doctor
