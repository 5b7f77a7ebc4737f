// SPDX-License-Identifier: Apache-2.0
// ViewWindow: a window on the desktop with an OpenGL 4.5 core context, by SDL2 (X11, Wayland; with
// SDL_VIDEODRIVER=offscreen no display at all). The context is current on the thread that opened
// it; everything happens there. One window per process.
#pragma once

#include <memory>
#include <string>

#include "roomcast/core/result.h"
#include "roomcast/viewer/view/view_target.h"

struct SDL_Window;

namespace roomcast::viewer {

struct ViewWindowOptions {
  std::string title = "roomcast";
  PictureSize size = {1280, 720};  // in the desktop's units: more pixels on a fine screen
  bool full_screen = false;
};

class ViewWindow final : public ViewTarget {
 public:
  /// kUnavailable, with what to do, when there is no display or no OpenGL 4.5.
  static Result<std::unique_ptr<ViewWindow>> open(const ViewWindowOptions& options);
  ~ViewWindow() override;
  ViewWindow(const ViewWindow&) = delete;
  ViewWindow& operator=(const ViewWindow&) = delete;

  /// In pixels, also on a fine (high-DPI) screen.
  [[nodiscard]] PictureSize size() const override;
  /// Pixels per unit of the desktop and of the mouse: 1, or 2 on a fine screen.
  [[nodiscard]] double pixels_per_unit() const;
  /// Nobody can see it: minimised.
  [[nodiscard]] bool is_hidden() const;

  /// Fills the window with the picture, scaled, its edges cut where shapes differ. Seen after
  /// present().
  void show(const render::OffscreenTarget& picture) override;
  /// Waits for the screen's refresh where the driver can.
  void present();
  /// What is in the window, before present().
  [[nodiscard]] ColorImage read() const;

  [[nodiscard]] bool is_full_screen() const;
  void set_full_screen(bool on);
  /// The mouse is hidden and tells only how far it moves.
  void capture_mouse(bool on);

  [[nodiscard]] SDL_Window* sdl() const { return window_; }
  [[nodiscard]] void* gl_context() const { return context_; }

 private:
  ViewWindow(SDL_Window* window, void* context) : window_(window), context_(context) {}

  SDL_Window* window_;
  void* context_;
};

}  // namespace roomcast::viewer
