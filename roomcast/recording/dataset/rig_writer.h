// SPDX-License-Identifier: Apache-2.0
// RigWriter: writes a recording of several sensors as a rig folder, frame by frame (layout:
// dataset/rig_json.h). The folder can be played at any moment: pictures appear complete (written
// under another name, then renamed), and the lists name only pictures that exist; rig.json's
// "source" notes that the recording is unfinished until finish(). Depth in millimetres, timestamps
// in nanoseconds of the sensor's own clock. Single-threaded, except for write_pictures.
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

/// One sensor of a rig: its description, and the deviation of its clock from true time.
struct RigSensor {
  source::SensorDescription
      description;  // `name` becomes ID and folder; `fps` is ignored, since the rig has one rate
  double clock_offset_s = 0;     // timestamp = true time + offset
  double rate_ppm = 0;           // its clock is this much too fast
  bool has_color = true;         // false: camera.json has no colour camera
  double expected_error_mm = 0;  // of an estimated pose, as in rig.json; 0: unknown
};

struct RigWriterOptions {
  std::string source;      // program that made the recording, for display in rig.json
  int jpeg_quality = 90;   // of colour, 1..100
  double scale_error = 0;  // as in rig.json; 0: unknown
};

/// Creates `directory` for a recording. kUnavailable: that fails, or it is not empty, since nothing
/// is overwritten.
[[nodiscard]] Status make_empty_folder(const std::filesystem::path& directory);

class RigWriter {
 public:
  /// Creates `directory` with rig.json and camera.json of each sensor. kInvalidArgument for names
  /// that are not folder names or not unique, and for cameras that fail their checks; kUnavailable
  /// if `directory` exists and is not empty, or cannot be written.
  static Result<RigWriter> create(const std::filesystem::path& directory, double fps,
                                  std::span<const RigSensor> sensors,
                                  const RigWriterOptions& options = {});

  /// Writes depth, and colour if there is any, as number `frame.index`; numbers must increase, and
  /// gaps become the rig's dropped frames. kInvalidArgument for wrong sizes or a number that does
  /// not increase; kUnavailable on a disk error.
  [[nodiscard]] Status add(std::size_t sensor, const source::CapturedFrame& frame,
                           nanoseconds timestamp);

  /// The two halves of `add`, for many frames at a time: write_pictures may be called from any
  /// thread; then the list lines are added in order.
  [[nodiscard]] Status write_pictures(std::size_t sensor, const source::CapturedFrame& frame) const;
  /// The same with colour that is a JPEG file already and stays as it is; `frame.color` is ignored.
  [[nodiscard]] Status write_pictures(std::size_t sensor, const source::CapturedFrame& frame,
                                      std::span<const std::uint8_t> jpeg) const;
  [[nodiscard]] Status list(std::size_t sensor, std::uint64_t index, bool has_color,
                            nanoseconds timestamp);
  /// Marks a number, higher than those before, as dropped. Needed only after a sensor's last frame;
  /// gaps are found by `add`.
  [[nodiscard]] Status drop(std::size_t sensor, std::uint64_t index);

  /// Writes rig.json again, with the dropped frames. The recording can be played without it.
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
