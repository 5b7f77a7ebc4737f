// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/window/view_window.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <SDL2/SDL.h>
#include <epoxy/gl.h>

#include "roomcast/render/gl/gl_libraries.h"

namespace roomcast::viewer {
namespace {

constexpr int kGlMajor = 4, kGlMinor = 5;

Error no_window(const std::string& what_failed) {
  const std::string reason = SDL_GetError();
  return {ErrorCode::kUnavailable,
          "no window can be opened here (" + what_failed +
              (reason.empty() ? std::string() : ": " + reason) +
              "); start it on a desktop with OpenGL 4.5, or use --headless --png FILE"};
}

void ask_for_gl() {
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, kGlMajor);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, kGlMinor);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);  // the room is drawn into a framebuffer object
}

void start_sdl() {
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");       // the program has its own
  SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "0");  // viewers watch without input
  SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "0");
}

SDL_Window* make_window(const ViewWindowOptions& options) {
  Uint32 flags = SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
  if (options.full_screen) flags |= SDL_WINDOW_FULLSCREEN_DESKTOP;
  return SDL_CreateWindow(options.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                          options.size.width, options.size.height, flags);
}

/// Where there is no display, SDL falls back to drivers whose windows nobody can see.
bool is_visible(std::string_view driver) {
  const bool was_named = std::getenv("SDL_VIDEODRIVER") != nullptr;
  return was_named || (driver != "offscreen" && driver != "dummy" && driver != "evdev");
}

bool has_gl() {
  return epoxy_is_desktop_gl() && epoxy_gl_version() >= 10 * kGlMajor + kGlMinor;
}

}  // namespace

Result<std::unique_ptr<ViewWindow>> ViewWindow::open(const ViewWindowOptions& options) {
  if (auto found = render::find_gl_libraries(); !found) return found.error();
  start_sdl();
  if (SDL_Init(SDL_INIT_VIDEO) != 0) return no_window("there is no display");
  if (!is_visible(SDL_GetCurrentVideoDriver())) {
    SDL_Quit();
    SDL_ClearError();
    return no_window("there is no display");
  }
  SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);  // may fail: the viewer works without a gamepad
  ask_for_gl();
  SDL_Window* const window = make_window(options);
  void* const context = window != nullptr ? SDL_GL_CreateContext(window) : nullptr;
  // Owns the window and the context from here on; its destructor ends SDL.
  std::unique_ptr<ViewWindow> made(new ViewWindow(window, context));
  if (window == nullptr) return no_window("the desktop refuses one");
  if (context == nullptr || !has_gl()) return no_window("the driver has no OpenGL 4.5");
  made->wait_for_screen(true);
  return made;
}

ViewWindow::~ViewWindow() {
  if (context_ != nullptr) SDL_GL_DeleteContext(context_);
  if (window_ != nullptr) SDL_DestroyWindow(window_);
  SDL_Quit();
}

PictureSize ViewWindow::size() const {
  PictureSize size;
  SDL_GL_GetDrawableSize(window_, &size.width, &size.height);
  return {std::max(1, size.width), std::max(1, size.height)};
}

double ViewWindow::pixels_per_unit() const {
  int width = 0, height = 0;
  SDL_GetWindowSize(window_, &width, &height);
  return height > 0 ? static_cast<double>(size().height) / height : 1;
}

bool ViewWindow::is_hidden() const {
  return (SDL_GetWindowFlags(window_) & (SDL_WINDOW_MINIMIZED | SDL_WINDOW_HIDDEN)) != 0;
}

/// If the aspect ratios differ, crops the picture's edges as little as possible.
void ViewWindow::show(const render::OffscreenTarget& picture) {
  const PictureSize all = size();
  const double scale = std::max(static_cast<double>(all.width) / picture.width(),
                                static_cast<double>(all.height) / picture.height());
  const int width = std::min(picture.width(), static_cast<int>(std::lround(all.width / scale)));
  const int height = std::min(picture.height(), static_cast<int>(std::lround(all.height / scale)));
  const int left = (picture.width() - width) / 2, bottom = (picture.height() - height) / 2;
  constexpr GLuint kWindow = 0;
  glBlitNamedFramebuffer(picture.framebuffer(), kWindow, left, bottom, left + width,
                         bottom + height, 0, 0, all.width, all.height, GL_COLOR_BUFFER_BIT,
                         scale == 1 ? GL_NEAREST : GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, kWindow);
  glViewport(0, 0, all.width, all.height);
}

void ViewWindow::present() {
  ++presented_;
  SDL_GL_SwapWindow(window_);
}

void ViewWindow::wait_for_screen(bool on) {
  if (std::exchange(waits_for_screen_, on) == on) return;
  constexpr int kAtOnce = 0, kWithScreen = 1, kLateRatherThanNever = -1;
  if (!on) {
    SDL_GL_SetSwapInterval(kAtOnce);
  } else if (SDL_GL_SetSwapInterval(kLateRatherThanNever) != 0) {
    SDL_GL_SetSwapInterval(kWithScreen);
  }
}

ColorImage ViewWindow::read() const {
  const PictureSize all = size();
  ColorImage image(all.width, all.height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadBuffer(GL_BACK);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, all.width, all.height, GL_RGB, GL_UNSIGNED_BYTE, image.data());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  for (int y = 0; y < all.height / 2; ++y) {
    Rgb8* const row = image.view().row(y);
    std::swap_ranges(row, row + all.width, image.view().row(all.height - 1 - y));
  }
  return image;
}

bool ViewWindow::is_full_screen() const {
  return (SDL_GetWindowFlags(window_) & SDL_WINDOW_FULLSCREEN_DESKTOP) != 0;
}

void ViewWindow::set_full_screen(bool on) {
  SDL_SetWindowFullscreen(window_, on ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
}

void ViewWindow::capture_mouse(bool on) {
  SDL_SetRelativeMouseMode(on ? SDL_TRUE : SDL_FALSE);
}

}  // namespace roomcast::viewer
