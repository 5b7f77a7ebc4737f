// SPDX-License-Identifier: Apache-2.0
// `sim:` sources: a simulated sensor as a FrameSource. Scene time is the host's monotonic clock, so
// the sensors of one host, in one process or in several, see the same instant of the same room.
// - Pace::kRealTime: frames at the instants k / fps plus a phase per sensor (sensors are not
//   synchronised); instants that the caller misses are skipped.
// - Pace::kAsFastAsPossible: frame i is at the instant i / fps, from scene time 0.
// With bump_at=S the sensor is displaced by bump_cm and bump_deg from S seconds after opening on.
// `device_time` is the scene time on the sensor's own clock, which has a fixed offset. No frames
// are lost, and the frame rate is exact.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "roomcast/core/parallel_rows.h"
#include "roomcast/core/result.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::simulator {

/// Maximum frame rate of a simulated source.
inline constexpr double kMaxSimulatedFps = 120.0;

struct SimulatedSourceOptions {
  source::Pace pace = source::Pace::kRealTime;
  double fps = 15;         // frames per second, above 0 and at most kMaxSimulatedFps
  int sensor_count = 3;    // number of sensors around the room
  std::uint64_t seed = 1;  // of noise and furniture
  Workers workers = {};    // for preparing the room
};

/// Opens sensor "s<index>" of `options.sensor_count` in the room named by `spec`
/// (simulated_spec.h). Its description has the reported calibration, the true world_from_depth and
/// options.fps. kNotFound for an unknown scene (the message lists them); kInvalidArgument for an
/// index, count, rate or option out of range; kUnavailable if the ray tracer does not start;
/// kClosed if the workers were stopped.
[[nodiscard]] Result<std::unique_ptr<source::FrameSource>> open_simulated_source(
    const std::string& spec, int sensor_index, const SimulatedSourceOptions& options = {});

}  // namespace roomcast::simulator
