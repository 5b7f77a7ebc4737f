// SPDX-License-Identifier: Apache-2.0
// `roomcast bench register`: how many frames a second one core registers (geometry/registration.h),
// beside the same method written to be read (geometry/registration_reference.h). Times are CPU
// milliseconds of the calling thread per frame, medians, so that other programs on the machine
// count little.
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
  double times_reference = 0;  // frames_per_cpu_s against that of the reference on the same input
  double seen_share = 0;       // of pixels with depth
};

struct RegisterBenchReport {
  int depth_width = 0, depth_height = 0, color_width = 0, color_height = 0;
  std::vector<RegisterBenchRow> rows;
};

/// One synthetic frame of Kinect v2 size (512x424 from 1920x1080, lens distortion, several surfaces,
/// textured).
[[nodiscard]] RegisterBenchInput synthetic_kinect_v2_input();

/// Up to `most_frames` frames with colour from the start of a recording. Errors of open_source and
/// of its frames; kInvalidArgument when no frame has colour.
[[nodiscard]] Result<RegisterBenchInput> recorded_input(const std::string& source_spec,
                                                        int most_frames);

/// Two rows for each input. kInvalidArgument for an input without frames or of other sizes than the
/// first; errors of Registration.
[[nodiscard]] Result<RegisterBenchReport> run_register_bench(
    const std::vector<RegisterBenchInput>& inputs, const RegisterBenchOptions& options = {});

void print_table(const RegisterBenchReport& report, std::ostream& out);
/// One JSON object: the fields of the report and its rows, by name.
void print_json(const RegisterBenchReport& report, std::ostream& out);

}  // namespace roomcast::bench
