// SPDX-License-Identifier: Apache-2.0
// FrameSource: anything that gives depth and colour of one sensor, frame by frame: a recording, the
// simulator, a camera. Everything above sees only this, so every feature works without hardware.
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

/// What a sensor says of itself before its first frame.
struct SensorDescription {
  std::string name;  // unique in its room, e.g. "s0"
  SensorCalibration calibration;
  std::optional<RigidTransform> world_from_depth;  // where the recording knows it
  double fps = 30;
};

/// Depth and colour of one instant. Reused from frame to frame by the caller.
struct CapturedFrame {
  DepthImage depth_mm;
  ColorImage color;  // full resolution; empty when the sensor has no colour for this frame
  std::uint64_t index =
      0;  // counts this source's frames; the recording's frame number for recordings
  nanoseconds
      device_time{};        // the sensor's own timestamp, untouched (another clock than the host's)
  HostTime capture_time{};  // the instant of capture on this host's clock
};

enum class Pace {
  kRealTime,          // a frame is given when it is due
  kAsFastAsPossible,  // every frame, at once; capture_time still advances as recorded
};

/// How a recording is played.
struct PlaybackOptions {
  Pace pace = Pace::kRealTime;
  bool loop = true;  // starts again at its end
};

/// How a source is doing.
struct SourceHealth {
  std::uint64_t frames_lost = 0;  // by the camera, on the way, or because nobody took them in time
  std::uint64_t times_unplugged = 0;
  bool is_there = true;  // false while a camera is waited for
};

class FrameSource {
 public:
  virtual ~FrameSource() = default;
  [[nodiscard]] virtual const SensorDescription& description() const = 0;

  /// Thread-safe.
  [[nodiscard]] virtual SourceHealth health() const { return {}; }

  /// Waits for the next frame and fills `frame` (its memory is used again). True: a frame. False:
  /// the source has ended, or `stop` was requested. Errors: kMalformed / kNotFound with the file
  /// and what is wrong with it.
  [[nodiscard]] virtual Result<bool> next(CapturedFrame& frame, std::stop_token stop) = 0;
};

}  // namespace roomcast::source
