// SPDX-License-Identifier: Apache-2.0
// Writes a simulated recording: a rig of all sensors of a scene, with the truth beside it.
//   OUT/                              a rig (source/rig_json.h), as the sensors report it: noisy
//                                     depth and colour, lenses as they believe them to be, stamps
//                                     of their own clocks, lost frames; world_from_depth is exact
//   OUT/truth/rig.json                exact poses; what the clocks were off by
//   OUT/truth/sK/camera.json          exact lenses and extrinsics
//   OUT/truth/sK/times.txt            number and true time in seconds of every frame, lost ones too
//   OUT/truth/sK/gains.txt            exposure and white balance: gains of linear light
//   OUT/truth/sK/%06d.png             depth of the same instants without noise, lost frames too
//   OUT/truth/sK/moving/%06d.png      255 where that depth is of something that can move (a person,
//                                     what they carry), even if it happens to stand still; 0 else
//   OUT/truth/sK/color/%06d.jpg       colour without noise, hardly compressed (if asked for)
//   OUT/truth/view_V_tT.png, ...      what is to be seen from free viewpoints (rig_views.h)
// Times are scene time, which starts at 0. The same options give the same files, bit for bit, on
// any number of threads; on machines with another libm nearly so.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

#include "roomcast/core/result.h"
#include "roomcast/simulator/sensing/frame_clock.h"
#include "roomcast/simulator/sensing/sensing_options.h"

namespace roomcast::simulator {

inline constexpr double kMaxSimulatedSeconds = 3600;
inline constexpr int kMaxSimulatedViews = 16;
inline constexpr int kMaxSimulatedViewSide = 4096;

struct SimulateRigOptions {
  std::string scene;       // "" is the first one
  int sensor_count = 3;    // 1..8
  double seconds = 5;      // above 0, at most kMaxSimulatedSeconds
  double fps = 30;         // above 0, at most kMaxSimulatedFps
  std::uint64_t seed = 1;  // noise, devices, and how things look
  double speed = 1;        // of all motion, 0..kMaxSimulatedSpeed: 0.05 slow motion, 0 stands still
  simulator::SensingOptions sensing;
  simulator::TimingOptions timing;
  bool truth_color = false;  // noise-free colour in truth/, too
  int views = 4;             // free viewpoints in truth/, 0..kMaxSimulatedViews
  int view_side_px = 1000;   // of their square pictures, 16..kMaxSimulatedViewSide
  int threads = 0;           // 0: all cores

  /// Perfect sensors that take their frames together.
  void clean() {
    sensing = sensing.clean();
    timing = simulator::TimingOptions::perfect();
  }
};

/// How far it is: called on the calling thread.
struct SimulateProgress {
  std::string_view doing;
  int done = 0, total = 0;
};
using SimulateWatcher = std::function<void(const SimulateProgress&)>;

/// kInvalidArgument for options out of range; kNotFound for an unknown scene; kUnavailable when the
/// folder is not empty or the disk fails, and then nothing is left of it. kClosed when `stop` was
/// requested: what has been written until then stays, as a whole recording that is shorter.
[[nodiscard]] Status simulate_rig(const std::filesystem::path& directory,
                                  const SimulateRigOptions& options,
                                  const SimulateWatcher& watcher = {}, std::stop_token stop = {});

}  // namespace roomcast::simulator
