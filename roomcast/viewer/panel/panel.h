// SPDX-License-Identifier: Apache-2.0
// Panel: shows connection, rates, latency by stage, sensors and their alignment, people, drawing
// settings, help and toasts, and lets the user change settings. Call draw() between
// PanelLayer::begin() and end().
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/viewer/report/latency_budget.h"
#include "roomcast/viewer/report/room_report.h"
#include "roomcast/viewer/report/toasts.h"
#include "roomcast/viewer/view/view_settings.h"
#include "roomcast/viewer/view/view_target.h"
#include "roomcast/viewer/window/viewer_command.h"

namespace roomcast::viewer {

/// The data that the panel shows.
struct PanelFacts {
  const client::RoomSnapshot& room;
  const RoomFigures& figures;
  std::optional<LatencyStages> latency;
  std::vector<Toast> toasts;
  double drawn_per_s = 0;        // of the room
  double drawing_ms = 0;         // of the last picture
  PictureSize size = {};         // of the last picture, or of each eye's, pixels
  bool is_worn = false;          // the last picture was the headset's
  double speed_m_per_s = 0;      // of walking
  std::string driver = {};       // of the GPU
  std::string video = {};        // file or folder being recorded; empty: none
  bool may_see_through = false;  // the headset can show what is around the wearer
  std::string headset = {};      // name and timing; empty: none
  std::string no_headset = {};  // why there is none, a sentence; empty: there is, or none is wanted
  std::optional<VoiceFacts> voice = {};  // of a viewer that hears
};

class Panel {
 public:
  [[nodiscard]] bool is_open() const { return is_open_; }
  void toggle() { is_open_ = !is_open_; }
  void toggle_help() { shows_help_ = !shows_help_; }
  [[nodiscard]] bool shows_help() const { return shows_help_; }

  /// Changes `settings` by the user's input; returns a command, if the user gave one.
  std::optional<ViewerCommand> draw(const PanelFacts& facts, ViewSettings& settings);

 private:
  std::optional<ViewerCommand> draw_sections(const PanelFacts& facts, ViewSettings& settings);
  void draw_toasts(const std::vector<Toast>& toasts);

  bool is_open_ = true, shows_help_ = false;
  float toasts_over_panel_ = 0;  // their height in the last picture, if they cover the panel
};

}  // namespace roomcast::viewer
