// SPDX-License-Identifier: Apache-2.0
// Writes free viewpoints of a simulated recording, for evaluating renderers, into one folder:
//   view_V_tT.png         colour from viewpoint V at instant T; no noise, gain 1
//   view_V_tT_depth.png   depth in millimetres, 16-bit
//   view_V_tT_seen.png    8-bit: bit i is set where sensor i sees that surface at that instant
//   views.json            lens, poses, instants, and the recorded frames nearest to them
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/simulator/sensing/frame_clock.h"
#include "roomcast/simulator/simulated_sensor.h"

namespace roomcast::simulator {

struct RigViewsOptions {
  int count = 4;           // viewpoints
  int side_px = 1000;      // of the square pictures, which are 90 degrees wide
  std::uint64_t seed = 1;  // determines the viewpoints
  double speed = 1;        // of all motion, as in the recording
  int frames = 0;          // of the recording
  Workers workers = {};
};

/// The instants are those of sensor 0's frames a third and two thirds into the recording (one
/// instant if it has fewer than three frames). kUnavailable on a disk error; kClosed if the workers
/// were stopped.
[[nodiscard]] Status write_rig_views(const std::filesystem::path& folder, const SimulatedRoom& room,
                                     std::span<const SimulatedSensor* const> sensors,
                                     std::span<const simulator::FrameClock> clocks,
                                     const RigViewsOptions& options,
                                     const std::function<void(int done, int total)>& progress);

}  // namespace roomcast::simulator
