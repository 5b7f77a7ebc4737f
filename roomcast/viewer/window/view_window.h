// SPDX-License-Identifier: Apache-2.0
// ViewWindow: a desktop window with an OpenGL 4.5 core context, by SDL2 (X11, Wayland, or no
// display with SDL_VIDEODRIVER=offscreen). Threading: only the thread that opened it; the context
// is current there. One window per process.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "roomcast/core/result.h"
#include "roomcast/viewer/view/view_target.h"

struct SDL_Window;

namespace roomcast::viewer {

struct ViewWindowOptions {
  std::string title = "roomcast";
  PictureSize size = {1280, 720};  // desktop units: more pixels on a high-DPI screen
  bool full_screen = false;
};

class ViewWindow final : public ViewTarget {
 public:
  /// kUnavailable, with advice, if there is no display or no OpenGL 4.5. A display that nobody can
  /// see is used only where SDL_VIDEODRIVER names it.
  static Result<std::unique_ptr<ViewWindow>> open(const ViewWindowOptions& options);
  ~ViewWindow() override;
  ViewWindow(const ViewWindow&) = delete;
  ViewWindow& operator=(const ViewWindow&) = delete;

  /// In pixels, also on a high-DPI screen.
  [[nodiscard]] PictureSize size() const override;
  /// Pixels per unit of the desktop and of the mouse: 1, or 2 on a high-DPI screen.
  [[nodiscard]] double pixels_per_unit() const;
  /// True if minimised.
  [[nodiscard]] bool is_hidden() const;

  /// Fills the window with the picture, scaled, and cropped if the aspect ratios differ. Visible
  /// after present().
  void show(const render::OffscreenTarget& picture) override;
  /// Waits for the screen's refresh if the driver supports that and wait_for_screen() is on.
  void present();
  /// On at first. Off while something else sets the pace, as a headset does.
  void wait_for_screen(bool on);
  [[nodiscard]] bool waits_for_screen() const { return waits_for_screen_; }
  [[nodiscard]] std::uint64_t presented() const { return presented_; }
  /// The window's content, before present().
  [[nodiscard]] ColorImage read() const;

  [[nodiscard]] bool is_full_screen() const;
  void set_full_screen(bool on);
  /// Hides the mouse, which then reports only its movement.
  void capture_mouse(bool on);

  [[nodiscard]] SDL_Window* sdl() const { return window_; }
  [[nodiscard]] void* gl_context() const { return context_; }

 private:
  ViewWindow(SDL_Window* window, void* context) : window_(window), context_(context) {}

  SDL_Window* window_;
  void* context_;
  bool waits_for_screen_ = false;
  std::uint64_t presented_ = 0;
};

}  // namespace roomcast::viewer
