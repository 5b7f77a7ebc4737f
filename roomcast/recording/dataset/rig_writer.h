// SPDX-License-Identifier: Apache-2.0
// RigWriter: writes a recording of several sensors as a rig folder, frame by frame (docs: data
// layout in source/rig_json.h). What is on disk can be played at any moment: pictures appear
// whole (written under another name, then renamed), and the lists name only pictures that are
// there; until it is finished, rig.json's "source" says so. Depth in millimetres, timestamps in
// nanoseconds of the sensor's own clock. Single-threaded, except for write_pictures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::recording {

/// One sensor of a rig: what it says of itself, and how its clock differs from true time.
struct RigSensor {
  source::SensorDescription
      description;  // `name` becomes id and folder; `fps` is not used, the rig has one rate
  double clock_offset_s = 0;  // stamp = true time + offset
  double rate_ppm = 0;        // its clock runs this much too fast
};

struct RigWriterOptions {
  std::string source;     // what made the recording, for people: goes into rig.json
  int jpeg_quality = 90;  // of colour, 1..100
};

class RigWriter {
 public:
  /// Makes `directory` with rig.json and camera.json of each sensor. kInvalidArgument for names
  /// that are no folder names or not unique, and for what camera checks refuse; kUnavailable if it
  /// exists and is not empty, or cannot be written.
  static Result<RigWriter> create(const std::filesystem::path& directory, double fps,
                                  std::span<const RigSensor> sensors,
                                  const RigWriterOptions& options = {});

  /// Writes depth, and colour if there is any, as number `frame.index`; numbers must grow and gaps
  /// become the rig's dropped frames. kInvalidArgument for wrong sizes or a number that does not
  /// grow; kUnavailable if the disk fails.
  [[nodiscard]] Status add(std::size_t sensor, const source::CapturedFrame& frame, nanoseconds timestamp);

  /// The two halves of `add`, for many frames at a time: the pictures, by any threads, and then, in
  /// order, their lines in the lists.
  [[nodiscard]] Status write_pictures(std::size_t sensor, const source::CapturedFrame& frame) const;
  [[nodiscard]] Status list(std::size_t sensor, std::uint64_t index, bool has_color,
                            nanoseconds timestamp);
  /// Says that this number, higher than those before, was lost. Gaps need no saying, ends do.
  [[nodiscard]] Status drop(std::size_t sensor, std::uint64_t index);

  /// Writes rig.json again, now with the dropped frames. Without it the recording still plays.
  [[nodiscard]] Status finish();

 private:
  struct Progress {
    bool started = false;
    std::uint64_t next_index = 0;
    std::vector<std::uint64_t> dropped;
  };
  RigWriter(std::filesystem::path directory, double fps, std::vector<RigSensor> sensors,
            RigWriterOptions options);
  [[nodiscard]] static Status check_index(const Progress& progress, std::uint64_t index);
  static void note_written(Progress& progress, std::uint64_t index);
  [[nodiscard]] Status write_cameras() const;
  [[nodiscard]] Status write_rig_json(const std::string& source) const;

  std::filesystem::path directory_;
  double fps_;
  std::vector<RigSensor> sensors_;
  std::vector<Progress> progress_;
  RigWriterOptions options_;
};

}  // namespace roomcast::recording
