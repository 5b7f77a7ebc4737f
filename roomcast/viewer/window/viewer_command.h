// SPDX-License-Identifier: Apache-2.0
// The commands of the desktop viewer, apart from moving, and their keys. The keyboard handler and
// the help use the same table.
#pragma once

#include <array>
#include <string_view>

namespace roomcast::viewer {

enum class ViewerCommand {
  kStart,
  kMouseLook,
  kModePoints,
  kModeSplats,
  kModeMesh,
  kModeAdaptive,
  kModeBlend,
  kModeStill,
  kPanel,
  kHelp,
  kFullScreen,
  kScreenshot,
  kVideo,
  kMicrophone,
  kRecenter,
  kRelease,
  kQuit,
};

struct KeyHelp {
  std::string_view keys, what;
};

/// Shown in the panel and in docs/guides/viewer.md.
inline constexpr std::array kKeyHelp = {
    KeyHelp{"drag", "turn around the middle"},
    KeyHelp{"right drag, Shift drag", "shift"},
    KeyHelp{"Ctrl drag", "look around"},
    KeyHelp{"wheel", "nearer, farther"},
    KeyHelp{"M", "look with the mouse; the wheel then sets the speed"},
    KeyHelp{"W A S D", "walk (Shift: faster)"},
    KeyHelp{"arrows", "turn, look up and down (Shift: faster)"},
    KeyHelp{"Q E", "down, up"},
    KeyHelp{"R", "back to the start"},
    KeyHelp{"L (hold)", "laser pointer at the mouse"},
    KeyHelp{"1 2 3 4 5 6", "points, splats, mesh, adaptive, blend, still"},
    KeyHelp{"Tab", "panel"},
    KeyHelp{"H, F1", "this help"},
    KeyHelp{"F, F11", "full screen"},
    KeyHelp{"P, F12", "screenshot"},
    KeyHelp{"V", "video: start, stop"},
    KeyHelp{"T", "microphone: on, off"},
    KeyHelp{"space bar (hold)", "speak, where the panel says so"},
    KeyHelp{"C", "headset: to the start; into the room again"},
    KeyHelp{"Esc", "release the mouse, close this, leave full screen"},
    KeyHelp{"Ctrl Q", "quit"},
    KeyHelp{"gamepad", "left stick walks, right stick looks, triggers down and up"},
    KeyHelp{"gamepad buttons", "A laser, B start, X blend, Y panel, shoulders speed"},
};

/// Shown below the others with --vr, and in docs/guides/viewer.md.
inline constexpr std::array kHeadsetHelp = {
    KeyHelp{"In the headset:", ""},
    KeyHelp{"left stick", "walk, where the head looks"},
    KeyHelp{"right stick, sideways", "turn"},
    KeyHelp{"right stick, forward", "aim at the floor; let go to be there"},
    KeyHelp{"trigger", "laser pointer"},
    KeyHelp{"Y, B or menu", "back to the start"},
};

}  // namespace roomcast::viewer
