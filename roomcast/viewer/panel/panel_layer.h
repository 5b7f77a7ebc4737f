// SPDX-License-Identifier: Apache-2.0
// PanelLayer: Dear ImGui in a ViewWindow: its context, fonts, events and drawing. Build the panel
// between begin() and end(). Threading: the window's thread; one PanelLayer per process (Dear ImGui
// has one current context).
#pragma once

#include <memory>

#include "roomcast/core/result.h"
#include "roomcast/viewer/window/view_window.h"

struct ImGuiContext;
union SDL_Event;

namespace roomcast::viewer {

class PanelLayer {
 public:
  /// The window must outlive it. kUnavailable if the driver's library cannot be loaded.
  static Result<std::unique_ptr<PanelLayer>> create(const ViewWindow& window);
  ~PanelLayer();
  PanelLayer(const PanelLayer&) = delete;
  PanelLayer& operator=(const PanelLayer&) = delete;

  /// True if the panel consumed the event.
  bool take(const SDL_Event& event);

  void begin();
  /// Draws the panel over the window's content.
  void end();

 private:
  explicit PanelLayer(const ViewWindow& window);
  bool start_backends();
  void set_style();

  struct Destroy {
    void operator()(ImGuiContext* context) const;
  };
  const ViewWindow& window_;
  std::unique_ptr<ImGuiContext, Destroy> context_;
  bool has_sdl_ = false, has_gl_ = false;
};

}  // namespace roomcast::viewer
