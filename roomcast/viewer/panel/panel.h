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
#include "roomcast/viewer/window/viewer_command.h"

namespace roomcast::viewer {

/// The data that the panel shows.
struct PanelFacts {
  const client::RoomSnapshot& room;
  const RoomFigures& figures;
  std::optional<LatencyStages> latency;
  std::vector<Toast> toasts;
  double drawn_per_s = 0;     // of the room
  double drawing_ms = 0;      // of the last picture
  int width = 0, height = 0;  // of the last picture, pixels
  double speed_m_per_s = 0;   // of walking
  std::string driver = {};    // of the GPU
  std::string video = {};     // file or folder being recorded; empty: none
  std::string headset = {};   // name and timing; empty: none
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
  bool is_open_ = true, shows_help_ = false;
};

}  // namespace roomcast::viewer
