// SPDX-License-Identifier: Apache-2.0
// `roomcast bench register`: frames per second that one core registers (geometry/registration.h),
// compared with a reference written for readability (geometry/registration_reference.h). Times are
// CPU milliseconds of the calling thread per frame. Medians limit the influence of other programs.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::bench {

struct RegisterBenchInput {
  std::string name;
  SensorCalibration calibration;
  std::vector<source::CapturedFrame> frames;  // with depth and colour
};

struct RegisterBenchOptions {
  double cpu_seconds_per_row = 0.5;
};

struct RegisterBenchRow {
  std::string input;
  std::string version;  // "fast" or "reference"
  double cpu_ms = 0;    // per frame, median
  double frames_per_cpu_s = 0;
  double times_reference = 0;  // frames_per_cpu_s relative to the reference on the same input
  double seen_share = 0;       // of pixels with depth
};

struct RegisterBenchReport {
  int depth_width = 0, depth_height = 0, color_width = 0, color_height = 0;
  std::vector<RegisterBenchRow> rows;
};

/// One synthetic frame of Kinect v2 size (512x424 from 1920x1080, lens distortion, several
/// surfaces, textured).
[[nodiscard]] RegisterBenchInput synthetic_kinect_v2_input();

/// Up to `most_frames` frames with colour from the start of a recording. Errors of open_source and
/// of its frames; kInvalidArgument when no frame has colour.
[[nodiscard]] Result<RegisterBenchInput> recorded_input(const std::string& source_spec,
                                                        int most_frames);

/// Two rows per input. kInvalidArgument: an input has no frames, or sizes differ within an input.
/// Errors of Registration.
[[nodiscard]] Result<RegisterBenchReport> run_register_bench(
    const std::vector<RegisterBenchInput>& inputs, const RegisterBenchOptions& options = {});

void print_table(const RegisterBenchReport& report, std::ostream& out);
/// One JSON object: the fields of the report and its rows, by name.
void print_json(const RegisterBenchReport& report, std::ostream& out);

}  // namespace roomcast::bench
