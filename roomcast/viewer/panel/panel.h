// SPDX-License-Identifier: Apache-2.0
// Panel: what a person is told beside the room and can set there: connection, rates, where the time
// goes, sensors and how well they are aligned, people, how to draw, help; and toasts. Between
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

/// Everything that is shown.
struct PanelFacts {
  const client::RoomSnapshot& room;
  const RoomFigures& figures;
  std::optional<LatencyStages> latency;
  std::vector<Toast> toasts;
  double drawn_per_s = 0;     // pictures of the room
  double drawing_ms = 0;      // of the last one
  int width = 0, height = 0;  // of the last one, pixels
  double speed_m_per_s = 0;   // of walking
  std::string driver = {};    // of the graphics card
  std::string video = {};     // what is being recorded; empty: nothing
  std::string headset = {};   // its name and how it does; empty: none
};

class Panel {
 public:
  [[nodiscard]] bool is_open() const { return is_open_; }
  void toggle() { is_open_ = !is_open_; }
  void toggle_help() { shows_help_ = !shows_help_; }
  [[nodiscard]] bool shows_help() const { return shows_help_; }

  /// Changes `settings` as the person does; gives what else is asked for.
  std::optional<ViewerCommand> draw(const PanelFacts& facts, ViewSettings& settings);

 private:
  bool is_open_ = true, shows_help_ = false;
};

}  // namespace roomcast::viewer
