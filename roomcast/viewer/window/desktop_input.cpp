// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/window/desktop_input.h"

#include <utility>

#include <SDL2/SDL.h>

namespace roomcast::viewer {
namespace {

std::optional<WalkKey> walk_key(SDL_Scancode key) {
  switch (key) {
    case SDL_SCANCODE_W:
      return WalkKey::kForward;
    case SDL_SCANCODE_S:
      return WalkKey::kBack;
    case SDL_SCANCODE_A:
      return WalkKey::kLeft;
    case SDL_SCANCODE_D:
      return WalkKey::kRight;
    case SDL_SCANCODE_E:
      return WalkKey::kUp;
    case SDL_SCANCODE_Q:
      return WalkKey::kDown;
    case SDL_SCANCODE_UP:
      return WalkKey::kLookUp;
    case SDL_SCANCODE_DOWN:
      return WalkKey::kLookDown;
    case SDL_SCANCODE_LEFT:
      return WalkKey::kTurnLeft;
    case SDL_SCANCODE_RIGHT:
      return WalkKey::kTurnRight;
    default:
      return std::nullopt;
  }
}

/// Uses the key's label, except for digits, which some layouts type with Shift.
std::optional<ViewerCommand> command_of(const SDL_Keysym& key) {
  switch (key.scancode) {
    case SDL_SCANCODE_1:
      return ViewerCommand::kModePoints;
    case SDL_SCANCODE_2:
      return ViewerCommand::kModeSplats;
    case SDL_SCANCODE_3:
      return ViewerCommand::kModeMesh;
    case SDL_SCANCODE_4:
      return ViewerCommand::kModeAdaptive;
    case SDL_SCANCODE_5:
      return ViewerCommand::kModeBlend;
    case SDL_SCANCODE_6:
      return ViewerCommand::kModeStill;
    default:
      break;
  }
  switch (key.sym) {
    case SDLK_r:
      return ViewerCommand::kStart;
    case SDLK_m:
      return ViewerCommand::kMouseLook;
    case SDLK_TAB:
      return ViewerCommand::kPanel;
    case SDLK_h:
    case SDLK_F1:
      return ViewerCommand::kHelp;
    case SDLK_f:
    case SDLK_F11:
      return ViewerCommand::kFullScreen;
    case SDLK_p:
    case SDLK_F12:
      return ViewerCommand::kScreenshot;
    case SDLK_v:
      return ViewerCommand::kVideo;
    case SDLK_t:
      return ViewerCommand::kMicrophone;
    case SDLK_c:
      return ViewerCommand::kRecenter;
    case SDLK_ESCAPE:
      return ViewerCommand::kRelease;
    default:
      return std::nullopt;
  }
}

double axis_of(Sint16 value) {
  return value < 0 ? value / 32768.0 : value / 32767.0;
}

Drag drag_of(Uint32 buttons, SDL_Keymod keys) {
  if ((buttons & (SDL_BUTTON_MMASK | SDL_BUTTON_RMASK)) != 0 || (keys & KMOD_SHIFT) != 0)
    return Drag::kPan;
  return (keys & KMOD_CTRL) != 0 ? Drag::kLook : Drag::kOrbit;
}

}  // namespace

DesktopInput::DesktopInput() = default;
DesktopInput::~DesktopInput() = default;
DesktopInput::DesktopInput(DesktopInput&&) noexcept = default;
DesktopInput& DesktopInput::operator=(DesktopInput&&) noexcept = default;

void DesktopInput::CloseGamepad::operator()(_SDL_GameController* pad) const {
  SDL_GameControllerClose(pad);
}

std::optional<ViewerCommand> DesktopInput::take(const SDL_Event& event,
                                                const PictureUnderMouse& picture,
                                                Navigation& navigation) {
  switch (event.type) {
    case SDL_QUIT:
      return ViewerCommand::kQuit;
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      return take_key(event, navigation);
    case SDL_MOUSEMOTION:
      take_motion(event, picture, navigation);
      break;
    case SDL_MOUSEWHEEL:
      if (mouse_looks_) {
        navigation.change_speed(event.wheel.preciseY);
      } else {
        navigation.zoom(event.wheel.preciseY);
      }
      break;
    case SDL_WINDOWEVENT:
      if (event.window.event != SDL_WINDOWEVENT_FOCUS_LOST) break;
      key_points_ = key_talks_ = false;
      navigation.release_all();
      break;
    case SDL_CONTROLLERDEVICEADDED:
      if (!pad_) pad_.reset(SDL_GameControllerOpen(event.cdevice.which));
      break;
    case SDL_CONTROLLERDEVICEREMOVED:
      pad_.reset();
      pad_points_ = false;
      navigation.set_sticks(sticks_ = {});
      break;
    case SDL_CONTROLLERAXISMOTION:
      take_pad_axis(event, navigation);
      break;
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP:
      return take_pad_button(event, navigation);
    default:
      break;
  }
  return std::nullopt;
}

std::optional<ViewerCommand> DesktopInput::take_key(const SDL_Event& event,
                                                    Navigation& navigation) {
  const bool down = event.type == SDL_KEYDOWN;
  const SDL_Keysym& key = event.key.keysym;
  const bool with_control = (key.mod & (KMOD_CTRL | KMOD_ALT | KMOD_GUI)) != 0;
  navigation.run((key.mod & KMOD_SHIFT) != 0);
  if (const auto way = walk_key(key.scancode)) {
    const bool quits = down && key.sym == SDLK_q && (key.mod & KMOD_CTRL) != 0;
    if (quits) return ViewerCommand::kQuit;
    if (!down || !with_control) navigation.hold(*way, down);
    return std::nullopt;
  }
  if (key.sym == SDLK_SPACE) {
    key_talks_ = down;
    return std::nullopt;
  }
  if (key.sym == SDLK_l) {
    key_points_ = down;
    return std::nullopt;
  }
  if (!down || with_control || event.key.repeat != 0) return std::nullopt;
  return command_of(key);
}

void DesktopInput::take_motion(const SDL_Event& event, const PictureUnderMouse& picture,
                               Navigation& navigation) {
  mouse_ = {static_cast<double>(event.motion.x), static_cast<double>(event.motion.y)};
  const bool drags =
      (event.motion.state & (SDL_BUTTON_LMASK | SDL_BUTTON_MMASK | SDL_BUTTON_RMASK)) != 0;
  if (!mouse_looks_ && !drags) return;
  const Drag kind = mouse_looks_ ? Drag::kLook : drag_of(event.motion.state, SDL_GetModState());
  navigation.drag(kind, event.motion.xrel, event.motion.yrel, picture.height_units,
                  picture.vertical_fov_rad);
}

void DesktopInput::take_pad_axis(const SDL_Event& event, Navigation& navigation) {
  const double value = axis_of(event.caxis.value);
  switch (event.caxis.axis) {
    case SDL_CONTROLLER_AXIS_LEFTX:
      sticks_.walk_right = value;
      break;
    case SDL_CONTROLLER_AXIS_LEFTY:
      sticks_.walk_forward = -value;
      break;
    case SDL_CONTROLLER_AXIS_RIGHTX:
      sticks_.look_right = value;
      break;
    case SDL_CONTROLLER_AXIS_RIGHTY:
      sticks_.look_up = -value;
      break;
    case SDL_CONTROLLER_AXIS_TRIGGERLEFT:
      trigger_down_ = value;
      break;
    case SDL_CONTROLLER_AXIS_TRIGGERRIGHT:
      trigger_up_ = value;
      break;
    default:
      return;
  }
  sticks_.walk_up = trigger_up_ - trigger_down_;
  navigation.set_sticks(sticks_);
}

std::optional<ViewerCommand> DesktopInput::take_pad_button(const SDL_Event& event,
                                                           Navigation& navigation) {
  const bool down = event.type == SDL_CONTROLLERBUTTONDOWN;
  if (event.cbutton.button == SDL_CONTROLLER_BUTTON_A) pad_points_ = down;
  if (!down) return std::nullopt;
  switch (event.cbutton.button) {
    case SDL_CONTROLLER_BUTTON_B:
      return ViewerCommand::kStart;
    case SDL_CONTROLLER_BUTTON_X:
      return ViewerCommand::kModeBlend;
    case SDL_CONTROLLER_BUTTON_Y:
      return ViewerCommand::kPanel;
    case SDL_CONTROLLER_BUTTON_LEFTSHOULDER:
      navigation.change_speed(-1);
      return std::nullopt;
    case SDL_CONTROLLER_BUTTON_RIGHTSHOULDER:
      navigation.change_speed(1);
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

}  // namespace roomcast::viewer
