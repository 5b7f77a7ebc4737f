// SPDX-License-Identifier: Apache-2.0
// `roomcast bench real`: what roomcast makes of a recording of a real rig, of which nobody knows
// the truth: which sensors alignment placed, what error it expects and what independent judges say,
// each sensor's noise and interference, whether the motion found in it is true, its bytes by codec,
// and what it sees when it is left out and drawn from the others.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "bench/codec/codec_bench.h"
#include "bench/real/left_out_view.h"
#include "bench/real/motion_forecast.h"
#include "bench/real/rig_judge.h"
#include "bench/real/sensor_condition.h"
#include "roomcast/alignment/rig/alignment_report.h"
#include "roomcast/core/result.h"

namespace roomcast::bench {

struct RealBenchOptions {
  int left_out_pictures = 3;  // for each placed sensor; 0: none
  int codec_frames = 300;     // of each sensor; 0: codecs are not measured
  bool conditions = true;     // measure noise and interference, and judge motion
};

struct SensorBytes {
  std::string sensor;
  std::vector<CodecBenchRow> rows;
};

struct RealReport {
  std::string rig, source;  // the folder's name; the program or camera as rig.json has it
  alignment::AlignmentReport alignment;
  RigJudgement judgement;
  std::vector<SensorCondition> conditions;
  std::vector<MotionForecast> motion;
  std::vector<SensorBytes> bytes;
  std::vector<LeftOutPicture> left_out;
  std::string not_drawn;  // why nothing was drawn; empty: it was
};

/// `alignment` is of this rig; its poses are drawn with, those of rig.json are not looked at.
/// Errors of the files and codecs. A machine without OpenGL is no error: `not_drawn` says so.
[[nodiscard]] Result<RealReport> run_real_bench(
    const std::filesystem::path& rig, const alignment::AlignmentReport& alignment,
    const RealBenchOptions& options, const std::function<void(const std::string&)>& progress);

void print_table(const RealReport& report, std::ostream& out);
/// A JSON array with one object for each rig.
void print_json(const std::vector<RealReport>& reports, std::ostream& out);

/// Writes `folder`/index.html with the figures and the pictures side by side, and the pictures
/// beside it. The folder is made. Errors of write_file.
[[nodiscard]] Status write_page(const std::vector<RealReport>& reports,
                                const std::filesystem::path& folder);

}  // namespace roomcast::bench
