// SPDX-License-Identifier: Apache-2.0
// Writes a simulated recording: a rig of all sensors of a scene, with its ground truth.
//   OUT/                              a rig (recording/dataset/rig_json.h), as reported: noisy
//                                     depth and colour, reported lens calibration, timestamps
//                                     of their own clocks, lost frames; world_from_depth is exact
//   OUT/truth/rig.json                exact poses; errors of the clocks; of harsh sensors also
//                                     "depth_scale" (true depth = depth_scale * reading),
//                                     "camera" and "registers_color"
//   OUT/truth/sK/camera.json          exact lenses and extrinsics
//   OUT/truth/sK/times.txt            number and true time (s) of every frame, also lost ones
//   OUT/truth/sK/gains.txt            exposure and white balance: gains of linear light
//   OUT/truth/sK/%06d.png             noise-free depth at the same instants, also lost frames
//   OUT/truth/sK/moving/%06d.png      255 where that depth is of a movable thing (a person,
//                                     a carried object), even if it is not moving; 0 elsewhere
//   OUT/truth/sK/color/%06d.jpg       noise-free colour, high-quality JPEG (optional)
//   OUT/truth/view_V_tT.png, ...      true views from free viewpoints (rig_views.h)
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
  std::uint64_t seed = 1;  // of noise, devices and the room's appearance
  double speed = 1;        // of all motion, 0..kMaxSimulatedSpeed: 0.05 slow motion, 0 no motion
  simulator::SensingOptions sensing;
  simulator::TimingOptions timing;
  bool truth_color = false;  // also write noise-free colour to truth/
  int views = 4;             // free viewpoints in truth/, 0..kMaxSimulatedViews
  int view_side_px = 1000;   // of their square pictures, 16..kMaxSimulatedViewSide
  int threads = 0;           // 0: all cores

  /// Error-free sensors that capture at the same instants.
  void clean() {
    sensing = sensing.clean();
    timing = simulator::TimingOptions::perfect();
  }
};

/// Progress; reported on the calling thread.
struct SimulateProgress {
  std::string_view doing;
  int done = 0, total = 0;
};
using SimulateWatcher = std::function<void(const SimulateProgress&)>;

/// kInvalidArgument for options out of range; kNotFound for an unknown scene; kUnavailable if the
/// folder is not empty or on a disk error; then all written files are removed. kClosed if `stop`
/// was requested: the files written until then remain, as a complete but shorter recording; there
/// are none if that was before the first frame.
[[nodiscard]] Status simulate_rig(const std::filesystem::path& directory,
                                  const SimulateRigOptions& options,
                                  const SimulateWatcher& watcher = {}, std::stop_token stop = {});

}  // namespace roomcast::simulator
