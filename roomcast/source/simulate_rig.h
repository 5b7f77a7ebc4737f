// SPDX-License-Identifier: Apache-2.0
// Writes a simulated recording: a rig of all sensors of a scene, with the truth beside it.
//   OUT/                      a rig (source/rig_json.h): noisy depth, colour, calibrations, poses
//   OUT/truth/<sensor>/%06d.png    depth of the same instants without noise
//   OUT/truth/<sensor>/moving/%06d.png  255 where that depth is of something that can move (a
//   person,
//                                  what they carry), even if it happens to stand still; 0 elsewhere
//   OUT/truth/<sensor>/color/%06d.jpg   colour without noise, hardly compressed (if asked for)
//   OUT/truth/<sensor>/times.txt   frame number and true time in seconds, one line each
// Frame i is the instant i / fps of scene time; the sensors' clocks agree with it. The same options
// give the same depth files, bit for bit, on the same machine.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "roomcast/core/result.h"

namespace roomcast {

struct SimulateRigOptions {
  std::string scene;         // "" is "livingroom"
  int sensor_count = 3;      // 1..8
  double seconds = 5;        // above 0, at most kMaxSimulatedSeconds
  double fps = 30;           // above 0, at most kMaxSimulatedFps
  std::uint64_t seed = 1;    // noise, and how things look
  double speed = 1;          // of all motion: 0.05 is slow motion, 0 stands still
  bool clean = false;        // the rig itself without noise, too
  bool truth_color = false;  // noise-free colour in truth/, too
};

inline constexpr double kMaxSimulatedSeconds = 3600;
inline constexpr double kMaxSimulatedSpeed = 10;
inline constexpr int kTruthJpegQuality = 97;

/// `progress` (may be empty) is called on the calling thread after every picture pair written.
/// kInvalidArgument for options out of range; kNotFound for an unknown scene; kUnavailable when the
/// folder is not empty or the disk fails.
[[nodiscard]] Status simulate_rig(const std::filesystem::path& directory,
                                  const SimulateRigOptions& options,
                                  const std::function<void(int done, int total)>& progress = {});

}  // namespace roomcast
