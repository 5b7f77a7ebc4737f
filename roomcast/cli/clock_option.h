// SPDX-License-Identifier: Apache-2.0
// The option --clock of commands that join recordings of several sensors.
#pragma once

#include <map>
#include <string>

#include <CLI/CLI.hpp>

#include "roomcast/cli/named_choice.h"
#include "roomcast/recording/import/room_timeline.h"

namespace roomcast::cli {

inline void add_clock_option(CLI::App& command, recording::JoiningClock& clock) {
  const std::map<std::string, recording::JoiningClock> clocks = {
      {"auto", recording::JoiningClock::kAutomatic},
      {"cable", recording::JoiningClock::kCable},
      {"start", recording::JoiningClock::kStart},
      {"time-of-day", recording::JoiningClock::kTimeOfDay}};
  choose_by_name(command.add_option("--clock", clock,
                                    "What joins recordings of several cameras: their own clocks, "
                                    "which a sync cable joined; the time of day; or their starts"),
                 clocks)
      ->default_str("auto");
}

}  // namespace roomcast::cli
