// SPDX-License-Identifier: Apache-2.0
// `roomcast bench frame-times`: how long a viewer with two eyes waits for a picture of a room, for
// each way to draw surfaces and each number of sensors. Times are of the driver it runs on: compare
// them only within one run.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/render/render_mode.h"

namespace roomcast::bench {

struct FrameTimesOptions {
  std::filesystem::path rig;                   // with true views, from the first of which one looks
  std::vector<render::RenderMode> modes = {};  // empty: all
  /// Beyond the rig's sensors, copies of them stand a little beside them.
  std::vector<int> sensors = {2, 4, 8, 16};
  int eye_pixels = 2000;  // width and height of each eye's part
  int frame_sets = 30;    // drawn for each row; the recording is repeated

  /// kInvalidArgument with the reason.
  [[nodiscard]] Status check() const;
};

/// Milliseconds, of all pictures of one kind.
struct Spread {
  double median = 0, p95 = 0;
};
[[nodiscard]] Spread spread_of(std::vector<double> values);

struct FrameTimesRow {
  std::string mode;
  int sensors = 0;
  /// Until a picture is finished: when all sensors have sent new frames since the last one (upload
  /// included), and when only the head has moved.
  Spread with_new_frames_ms, without_ms;
  Spread gpu_ms;  // of pictures without new frames, between the first and the last command
};

struct FrameTimesReport {
  std::string rig, driver;
  int eye_pixels = 0;
  std::vector<FrameTimesRow> rows;
};

/// Makes its own GL context. kUnavailable: no driver. kInvalidArgument as FrameTimesOptions::check.
/// Errors of the files.
[[nodiscard]] Result<FrameTimesReport> run_frame_times(
    const FrameTimesOptions& options, const std::function<void(const std::string&)>& progress);

void print_table(const FrameTimesReport& report, std::ostream& out);
/// One JSON object: the fields of the report and its rows, by name.
void print_json(const FrameTimesReport& report, std::ostream& out);

}  // namespace roomcast::bench
