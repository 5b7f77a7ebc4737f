// SPDX-License-Identifier: Apache-2.0
// `roomcast bench moved-furniture`: how long the model of a running room still has a piece of
// furniture that was moved: a hub, simulated sensors, a modeler and a viewer in one process, over
// loopback. Seconds; real time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::bench {

struct MovedFurnitureOptions {
  std::string scene = "livingroom";
  std::uint64_t seed = 41;
  int sensors = 3;
  double fps = 5;
  double stretch_s = 60;  // from one move to the next
  int moves = 2;
  /// The viewer says where it looks, from a corner over the room: key frames are rare then.
  bool looks = false;
};

struct MovedFurnitureMove {
  std::size_t points = 0;  // of the model within the cabinet, before the move
  double forgotten_s = 0;  // until less than a twentieth of them were left; 0: never
};

struct MovedFurnitureReport {
  std::vector<MovedFurnitureMove> moves;  // of those where the cabinet was in the model
  double modelled_s = 0;                  // from the viewer's joining to the first model
  std::size_t triangles = 0, bytes = 0;   // of the last model
  double key_frames_per_minute = 0;       // of a sensor, as the viewer gets them
};

[[nodiscard]] Result<MovedFurnitureReport> run_moved_furniture(
    const MovedFurnitureOptions& options, const std::function<void(const std::string&)>& progress);

void print_table(const MovedFurnitureReport& report, std::ostream& out);

}  // namespace roomcast::bench
