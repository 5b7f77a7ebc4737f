// SPDX-License-Identifier: Apache-2.0
// FrameSource: the interface to a source of depth and colour frames of one sensor: a recording, the
// simulator, a camera. All other code uses only this interface, so that every feature works without
// hardware.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::source {

/// Properties of a sensor, known before its first frame.
struct SensorDescription {
  std::string name;  // unique in its room, e.g. "s0"
  SensorCalibration calibration;
  std::optional<RigidTransform> world_from_depth;  // if the recording contains it
  double fps = 30;
};

/// Depth and colour of one instant. Reused from frame to frame by the caller.
struct CapturedFrame {
  DepthImage depth_mm;
  ColorImage color;           // full resolution; empty if the sensor has no colour for this frame
  std::uint64_t index = 0;    // number of the frame in this source; a recording's own frame number
  nanoseconds device_time{};  // the sensor's own timestamp, unchanged (not the host's clock)
  HostTime capture_time{};    // the instant of capture on this host's clock
};

enum class Pace {
  kRealTime,          // each frame at its due time
  kAsFastAsPossible,  // every frame, at once; capture_time still advances as recorded
};

/// Options of a recording's playback.
struct PlaybackOptions {
  Pace pace = Pace::kRealTime;
  bool loop = true;  // restarts at the end
};

/// Counters and state of a source.
struct SourceHealth {
  std::uint64_t frames_lost = 0;  // by the camera, in transfer, or not read in time
  std::uint64_t disconnect_count = 0;
  bool is_connected = true;  // false while waiting for a lost camera
};

class FrameSource {
 public:
  virtual ~FrameSource() = default;
  [[nodiscard]] virtual const SensorDescription& description() const = 0;

  /// Thread-safe.
  [[nodiscard]] virtual SourceHealth health() const { return {}; }

  /// From now on next() is called a few times a second only (true), or for every frame again
  /// (false). Frames that are not read while the source is idle do not count as lost.
  virtual void set_idle(bool /*is_idle*/) {}

  /// Waits for the next frame and fills `frame` (its memory is reused). Returns true for a frame,
  /// false if the source has ended or `stop` was requested. Errors: kMalformed / kNotFound with the
  /// file and its problem.
  [[nodiscard]] virtual Result<bool> next(CapturedFrame& frame, std::stop_token stop) = 0;
};

}  // namespace roomcast::source
