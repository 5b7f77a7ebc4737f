// SPDX-License-Identifier: Apache-2.0
// DesktopInput: turns SDL's events of mouse, keyboard and gamepad into movement (Navigation) and
// commands. Events that the panel consumes are not passed to it.
#pragma once

#include <memory>
#include <optional>

#include "roomcast/viewer/walk/navigation.h"
#include "roomcast/viewer/window/viewer_command.h"

union SDL_Event;
struct _SDL_GameController;

namespace roomcast::viewer {

/// The picture under the mouse.
struct PictureUnderMouse {
  double height_units = 720;  // desktop units, as the mouse's
  double vertical_fov_rad = 1;
};

/// Mouse position in desktop units from the top left.
struct MousePlace {
  double x = 0, y = 0;
};

class DesktopInput {
 public:
  DesktopInput();
  ~DesktopInput();
  DesktopInput(DesktopInput&&) noexcept;
  DesktopInput& operator=(DesktopInput&&) noexcept;

  /// Moves `navigation`, returns a command, or ignores the event.
  [[nodiscard]] std::optional<ViewerCommand> take(const SDL_Event& event,
                                                  const PictureUnderMouse& picture,
                                                  Navigation& navigation);

  /// On: moving the mouse turns the head, and the wheel sets the speed.
  void set_mouse_look(bool on) { mouse_looks_ = on; }
  [[nodiscard]] bool mouse_looks() const { return mouse_looks_; }
  /// True while the laser pointer's key or button is held.
  [[nodiscard]] bool is_pointing() const { return key_points_ || pad_points_; }
  /// True while the key for push to talk is held.
  [[nodiscard]] bool is_talking() const { return key_talks_; }
  [[nodiscard]] const MousePlace& mouse() const { return mouse_; }

 private:
  struct CloseGamepad {
    void operator()(_SDL_GameController* pad) const;
  };

  std::optional<ViewerCommand> take_key(const SDL_Event& event, Navigation& navigation);
  void take_motion(const SDL_Event& event, const PictureUnderMouse& picture,
                   Navigation& navigation);
  std::optional<ViewerCommand> take_pad_button(const SDL_Event& event, Navigation& navigation);
  void take_pad_axis(const SDL_Event& event, Navigation& navigation);

  std::unique_ptr<_SDL_GameController, CloseGamepad> pad_;
  Sticks sticks_;
  double trigger_up_ = 0, trigger_down_ = 0;
  MousePlace mouse_;
  bool mouse_looks_ = false;
  bool key_points_ = false, pad_points_ = false, key_talks_ = false;
};

}  // namespace roomcast::viewer
