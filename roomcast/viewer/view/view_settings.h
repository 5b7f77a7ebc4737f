// SPDX-License-Identifier: Apache-2.0
// User settings of the viewer: how the room is drawn, comfort in a headset, and voice.
#pragma once

#include <numbers>
#include <set>

#include "roomcast/core/ids.h"
#include "roomcast/render/blend/blend_renderer.h"
#include "roomcast/render/render_mode.h"
#include "roomcast/viewer/voice/voice_settings.h"

namespace roomcast::viewer {

/// Comfort in a headset. Docs: docs/guides/viewer.md.
struct ComfortOptions {
  bool smooth_walk = true;  // false: the walking stick teleports, too
  bool snap_turn = true;    // turns in steps; smooth turning makes many people sick
  double snap_rad = std::numbers::pi / 6;
  double smooth_turn_rad_per_s = 1.4;
  double walk_speed_m_per_s = 1.4;
  bool sees_through = false;  // the wearer's own room behind the surfaces, where displays can
  bool left_handed = false;   // the left hand turns and teleports, the right one walks
};

struct ViewSettings {
  render::RenderMode mode = render::RenderMode::kBlend;
  render::Unseen unseen = render::Unseen::kSurroundings;
  bool floor_grid = true;
  bool automatic_scale = true;  // adapts the resolution so that drawing keeps up
  double render_scale = 1;      // share of the window's pixels
  double vertical_fov_rad = std::numbers::pi / 3;
  std::set<SensorId> hidden;
  ComfortOptions comfort;
  VoiceSettings voice;
};

}  // namespace roomcast::viewer
