// SPDX-License-Identifier: Apache-2.0
// SensorFile: one sensor in a recording of another program: its description, the times of its
// pictures, and the pictures one at a time. Formats implement it; FileSource plays it, and
// write_imported_rig turns it into a rig. Single-threaded.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::recording {

/// The most frames of one sensor: 12 hours at 90 frames/s.
inline constexpr std::size_t kMaxSensorFrames = 4U << 20U;

/// The clock of a recording's sensor, as far as the file states it.
struct SensorClock {
  /// Time of day (UTC since 1970) minus device time, if known, and the largest error of that.
  std::optional<nanoseconds> utc_minus_device;
  nanoseconds utc_error{};
  /// A sync cable joined the sensor to others: their device times are of one clock.
  bool is_cable_primary = false, is_cable_secondary = false;
  /// The device times of all sensors with the same text here, which is not empty, are of one clock.
  std::string recording = {};
};

struct SensorFileInfo {
  source::SensorDescription description;
  /// Device time of each frame's depth, increasing; at least one.
  std::vector<nanoseconds> times;
  SensorClock clock;
  bool has_color = true;
  /// Sentences for people: what was converted, what is missing, where the file is damaged.
  std::vector<std::string> notes;
};

class SensorFile {
 public:
  virtual ~SensorFile() = default;
  [[nodiscard]] virtual const SensorFileInfo& info() const = 0;

  /// Depth in millimetres, in the calibration's size. Errors (kMalformed, kUnsupported, kTooLarge)
  /// name the file; the frames after it may be readable. `frame` is below info().times.size().
  [[nodiscard]] virtual Status read_depth(std::size_t frame, DepthImage& depth_mm) = 0;
  /// Colour in the calibration's size; empty if the frame has none. Errors as above.
  [[nodiscard]] virtual Status read_color(std::size_t frame, ColorImage& color) = 0;
  /// The bytes of the frame's colour if it was recorded as JPEG of that size; else empty. They are
  /// not decoded.
  [[nodiscard]] virtual Status read_jpeg(std::size_t /*frame*/, std::vector<std::uint8_t>& jpeg) {
    jpeg.clear();
    return {};
  }
};

}  // namespace roomcast::recording
